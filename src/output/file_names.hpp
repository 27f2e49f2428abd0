// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <set>
#include <string>

namespace triax::src {

/// Names for files of things that people named: no two alike, not even where a file system takes
/// upper and lower case for one, and short enough to have more put behind them.
class FileNames {
 public:
  /// `stem` consists of ASCII characters that may stand in a file name. What is taken already, and
  /// what had to be cut, has `number` behind it ("a_b_7"), and where that is taken one more
  /// ("a_b_7_2").
  std::string take(const std::string& stem, std::int64_t number);

 private:
  std::set<std::string> taken_;  ///< in lower case
};

}  // namespace triax::src
