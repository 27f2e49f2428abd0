// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "lab/intake/restart_finder.hpp"
#include "lab/records/findings.hpp"
#include "lab/records/table_reader.hpp"

namespace triax::lab {

/// Finds the row of a record in which a second test begins (RestartFinder, or another value in a
/// column that numbers the tests), in constant memory.
class TestRestart {
 public:
  /// `file` is named in messages.
  explicit TestRestart(std::string file) : file_(std::move(file)) {}

  /// Processes the next row, as the file has it. Returns the row with which another test begins as
  /// soon as it is confirmed. The first row of a stage that the test did not have before begins
  /// none.
  std::optional<Restart> find(const Row& row);
  /// The same. Throws SeveralTests with the line and the number of the reading.
  void add(const Row& row);
  /// The record is over: notes a return to the start that was not confirmed.
  void finish(Findings& findings) const;

 private:
  RowState state_of(const Row& row);
  bool begins_new_stage(const Row& row);
  std::string describe(const Restart& restart) const;

  std::string file_;
  std::optional<Quantity> strain_, pressure_;  ///< their columns
  double test_ = kMissing;                     ///< number of the test in the row before
  std::set<double> stages_;                    ///< of this test
  std::int64_t last_line_ = 0, readings_ = 0;
  RestartFinder finder_;
};

}  // namespace triax::lab
