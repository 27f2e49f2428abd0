// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The rows of a table with which a second test begins.
#include <array>
#include <cstdint>
#include <optional>

namespace triax::lab {

/// Values with which a test starts and from which its rows move away, in any unit, NaN where a row
/// has no value. The load is q or the axial force; the pressure an effective stress or a pore
/// pressure.
enum class RowValue : std::uint8_t { strain, load, pressure, cycle, time };
inline constexpr std::size_t kRowValueCount = 5;
using RowState = std::array<double, kRowValueCount>;
constexpr std::size_t index(RowValue value) { return static_cast<std::size_t>(value); }

struct Restart {
  RowState before{}, first{};  ///< of the last row of a test, and the first of the next one
  std::int64_t line_before = 0, line = 0;
  std::int64_t reading = 0;  ///< number of the row, from 0
  bool is_time_back() const { return first[index(RowValue::time)] < before[index(RowValue::time)]; }
};

/// Finds the rows in which another test begins, in constant memory. The strain returns to its first
/// value or below, and one of these is true, which no specimen does:
///   the strain jumps, and the time runs back or the load returns to its first value
///   the time runs back to its start, and the load returns
///   load and effective stress (or pore pressure) return, one of them or the cycle number by a jump
/// A jump is more than kJump_steps times the largest step per row before it. A specimen that is
/// unloaded keeps most of its strain, and a cyclic test comes back in steps like those before. A
/// load that only scatters, as before shear, has nowhere to return from: its steps are as large as
/// its range. A new stage may begin with a counter that was set to zero, and is no second test.
///
/// The rows that follow confirm it, so that a row out of place or cells that fell out do not count.
class RestartFinder {
 public:
  static constexpr double kJump_steps = 2;
  static constexpr double kReturned_fraction =
      0.05;  ///< of the largest distance from the first value

  /// Processes the next row. Returns the row in which another test began as soon as later rows
  /// confirm it; the search then goes on with that test. `begins_new_stage`: the row is the first
  /// of a stage that no row had before.
  std::optional<Restart> add(const RowState& now, std::int64_t line, bool begins_new_stage);
  /// A return to the start that no row has confirmed yet.
  std::optional<Restart> open() const;

 private:
  /// One value of the rows, and how it moved.
  struct Track {
    double first, last;
    double largest = 0;       ///< distance from the first value
    double largest_step = 0;  ///< between two rows
    int steps = 0;
    int rows_since_last = 1;  ///< more than one where values are missing
    Track();
    bool is_returned(double now) const;
    bool is_unloaded(double now) const;
    bool jumps(double now) const;
    void add(double now, bool begins_new_stage);
    void skip() { ++rows_since_last; }
  };
  using Tracks = std::array<Track, kRowValueCount>;
  struct Candidate {
    Candidate();
    Restart restart;
    Tracks tracks;  ///< of the rows from restart.first on
    int rows = 1;
  };

  bool is_back_at_start(const RowState& now) const;
  std::optional<Restart> follow(const RowState& now);
  static void continue_test(Tracks& tracks, const RowState& now, bool begins_new_stage);
  const Track& track(RowValue value) const { return tracks_[index(value)]; }

  Tracks tracks_;
  std::int64_t last_line_ = 0, readings_ = 0;
  std::optional<Candidate> candidate_;
};

}  // namespace triax::lab
