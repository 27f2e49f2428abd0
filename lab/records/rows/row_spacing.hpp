// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "lab/records/findings.hpp"

namespace triax::lab {

/// Notes rows that are missing from an even series: between two rows the value moves on by two or
/// more steps, while the steps before and after are all equal within kEven_fraction. A series of
/// uneven steps, or one that changes its step, says nothing.
class RowSpacing {
 public:
  static constexpr double kEven_fraction = 0.1;
  static constexpr int kRows_before = 10, kRows_after = 3;

  /// `name` of the value in messages, which give it in SI.
  explicit RowSpacing(std::string name) : name_(std::move(name)) {}

  /// Processes the value of the next row, SI; `restarts` where its step to the row before does not
  /// count, as where a stage begins.
  void add(double value, std::int64_t line, bool restarts, Findings& findings);

 private:
  struct Gap {
    double from = 0, to = 0;
    std::int64_t line = 0;
    int even_steps_after = 0;
  };
  void report(const Gap& gap, Findings& findings) const;

  std::string name_;
  std::optional<double> last_;
  double step_ = 0;  ///< mean of the even steps
  int even_steps_ = 0;
  std::optional<Gap> gap_;
};

}  // namespace triax::lab
