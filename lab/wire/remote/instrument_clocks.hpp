// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Clocks of instruments that say when they read, beside this machine's. Readings keep this
// machine's time; that an instrument's own clock jumps or runs fast is told, since who lays its
// files beside ours needs to know.
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace triax::lab {

class InstrumentClocks {
 public:
  /// What a clock may be off before it is told, on the clock of this machine: a served rig's plant
  /// catches up with what it was late within a second.
  static constexpr double kTolerance_s = 1;
  /// Times are of a test that runs `speed` times faster than this machine's clock.
  explicit InstrumentClocks(double speed = 1) : tolerance_s_(kTolerance_s * speed) {}

  /// A reading that the instrument says it took at `stamp_s` on its own clock, between `asked_s`
  /// and `answered_s` of this machine's.
  void take(const std::string& instrument, double stamp_s, double asked_s, double answered_s);
  /// Since the last call, a sentence each: "scanner has a clock that jumped by +7.0 s ...".
  std::vector<std::string> news() { return std::exchange(news_, {}); }

 private:
  /// Where the clock stands beside ours: stamp less our time, which the answer's duration leaves
  /// open.
  struct Offset {
    double least_s, most_s;
  };
  struct Clock {
    Offset start, last;
    double start_s = 0, told_s = 0;  ///< our time; drift that was told
  };
  double tolerance_s_;
  std::map<std::string, Clock> all_;
  std::vector<std::string> news_;
};

}  // namespace triax::lab
