// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

namespace triax::lab {

class WireInstrument;

/// Which instruments give no readings, and why, as it is told: each kind of cause of a gap once,
/// and its end.
class Absences {
 public:
  /// What was wrong with its last scan or order; empty: nothing.
  void take(const WireInstrument& one, const std::string& why) { all_[&one].why = why; }
  const std::string& why(const WireInstrument& one) { return all_[&one].why; }
  /// Since the last call, a sentence each: "scanner gives no readings: no answer within 0.5 s",
  /// "scanner answers again after 5.2 s". Times are those of the test.
  std::vector<std::string> news(double now_s);

 private:
  struct Gap {
    std::string why;
    std::set<std::string> told;  ///< kinds of cause; empty: there is no gap
    double since_s = 0;
  };
  std::map<const WireInstrument*, Gap> all_;
};

}  // namespace triax::lab
