// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <stdexcept>
#include <string>

namespace triax::src {

/// Exit statuses of a command that drives or reads a rig, beside 0, 1 and 2 of all commands.
enum class EarlyEnd : int {
  failed_rig = 3,  ///< an instrument, a drive or this program failed; a run is in its safe state
  aborted = 4,     ///< by the operator
  unfinished = 5   ///< a stage could not reach its end
};

/// The command stored what there is, and ended in another way than it was asked to: one line for
/// standard error, and the status.
class EndedEarly : public std::runtime_error {
 public:
  EndedEarly(EarlyEnd end, const std::string& message) : std::runtime_error(message), end_(end) {}
  int status() const { return static_cast<int>(end_); }

 private:
  EarlyEnd end_;
};

}  // namespace triax::src
