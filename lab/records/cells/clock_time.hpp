// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Times as clocks show them, where loggers write these instead of seconds.
#include <optional>
#include <string_view>

namespace triax::lab {

/// "06:30:24", "6:30", "06:30:24.5" in s since midnight; with a date before it ("2019-02-11",
/// "11.02.2019", "11/02/2019": the day first) in s since 1970-01-01. Nothing for any other text.
std::optional<double> clock_seconds(std::string_view text);

/// Makes a time of the test of the clock's: it begins at 0, and where a clock without a date passes
/// midnight it goes on.
class Clock {
 public:
  double since_start(double seconds);

 private:
  std::optional<double> first_;
  double last_ = 0, days_ = 0;
};

}  // namespace triax::lab
