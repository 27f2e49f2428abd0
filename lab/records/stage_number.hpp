// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "lab/records/findings.hpp"

namespace triax::lab {

/// Stage numbers of a record as whole numbers; "4.1" of an advanced module becomes 41.
class StageNumbers {
 public:
  /// `file` is named in messages.
  explicit StageNumbers(std::string file) : file_(std::move(file)) {}

  /// Throws BadInput "FILE:LINE: ..." for what is no number of a stage, and where two stages of the
  /// file would get one number (4.1 beside 41). A stage that is renamed is a finding.
  int of(double value, std::int64_t line, Findings& findings);

 private:
  std::string file_;
  std::map<int, double> seen_;  // the value in the file behind each number
};

}  // namespace triax::lab
