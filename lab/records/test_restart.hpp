// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "lab/records/findings.hpp"
#include "lab/records/table_reader.hpp"

namespace triax::lab {

/// Finds the row in which a second test begins, in constant memory. The strain returns to its first
/// value, and one of these is true, which no specimen does:
///   the strain jumps, and the time runs back or the deviatoric load returns to its first value
///   the time runs back to its start, and the load returns
///   load and effective stress (or pore pressure) return, one of them or the cycle number by a jump
/// A jump is more than kJump_steps times the largest step before it. A specimen that is unloaded
/// keeps most of its strain, and a cyclic test comes back in steps like those before. A new stage
/// may begin with a counter that was set to zero, and is no second test.
///
/// The rows that follow confirm it, so that a row out of place or cells that fell out do not count.
class TestRestart {
 public:
  static constexpr double kJump_steps = 2;
  static constexpr double kReturned_fraction =
      0.05;  ///< of the largest distance from the first value

  /// `file` is named in messages.
  explicit TestRestart(std::string file) : file_(std::move(file)) {}

  /// Processes the next row, as the file has it; `reading` counts from 0. `begins_new_stage`: the
  /// row is the first of a stage number that no row had before. Throws BadInput, with the line and
  /// the number of the reading with which the second test begins, as soon as it is confirmed.
  void add(const Row& row, std::int64_t reading, bool begins_new_stage);
  /// The record is over: notes a return to the start that was not confirmed.
  void finish(Findings& findings) const;

 private:
  /// One value of the rows, and how it moved.
  struct Track {
    double first = kMissing, last = kMissing;
    double largest = 0;       ///< distance from the first value
    double largest_step = 0;  ///< between two rows
    bool is_returned(double now) const;
    bool jumps(double now) const;
    void add(double now, bool begins_new_stage);
  };
  enum Value : std::size_t { kStrain, kLoad, kPressure, kCycle, kTime, kValueCount };
  using Values = std::array<double, kValueCount>;
  struct Candidate {
    Values before{}, first{};
    std::int64_t line_before = 0, line = 0, reading = 0;
    double last_strain = 0;
    int rows = 1;
    bool time_back() const { return first[kTime] < before[kTime]; }
  };

  Values values_of(const Row& row);
  bool is_back_at_start(const Values& now) const;
  void follow(const Values& now);
  void continue_test(const Values& now, bool begins_new_stage);
  std::string describe(const Candidate& candidate) const;

  std::string file_;
  std::optional<Quantity> strain_, pressure_;  ///< their columns
  std::array<Track, kValueCount> tracks_{};
  std::int64_t last_line_ = 0;
  std::optional<Candidate> candidate_;
};

}  // namespace triax::lab
