// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The columns of one test in memory, as far as somebody asked for them: what windows are cut from.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "db/scans/read_columns.hpp"
#include "db/store.hpp"
#include "lab/health/faulty_spans.hpp"

namespace triax::study {

/// All scans of a test so far, column by column, in units of the field. What was read once is not
/// read again: a test that runs grows by what is new. Not for several threads.
class TestColumns {
 public:
  explicit TestColumns(std::int64_t test) : test_(test) {}

  /// Reads what is missing of these columns (places in db::read_columns()). `grows`: the test may
  /// have more scans than at the last call.
  void read(const db::Store& store, std::span<const std::size_t> columns, bool grows);
  /// The same of the points of second-order work.
  void read_work(const db::Store& store, bool grows);

  std::int64_t test() const { return test_; }
  const std::vector<std::int64_t>& readings() const { return readings_; }
  /// Pre-condition: it was read.
  const std::vector<double>& column(std::size_t place) const { return *columns_[place]; }
  const std::vector<lab::SecondOrderWorkPoint>& work() const { return work_; }
  /// Readings whose step from the reading before has nothing between (lab::UnreadSteps), rising;
  /// none before q was read.
  const std::vector<std::int64_t>& unread_steps() const { return unread_steps_; }
  /// Sensors that cannot be believed; what was read on them or follows from it is missing in the
  /// columns.
  struct Fault {
    lab::FaultySpan span;
    std::vector<std::size_t> columns;  ///< places in db::read_columns()
  };
  const std::vector<Fault>& faults() const { return faults_; }
  /// What it takes at most to hold so many scans of these columns and of those that are there
  /// already; with `work`, or where they are there, the points of second-order work as well.
  std::size_t bytes_with(std::span<const std::size_t> columns, bool work, std::size_t scans) const;

 private:
  void read_whole(const db::Store& store, const std::vector<std::size_t>& missing);
  void read_new(const db::Store& store);
  void find_faults(const db::Store& store);
  void remove_faulty();
  void find_unread_steps();

  std::int64_t test_;
  std::vector<std::int64_t> readings_;
  std::vector<std::optional<std::vector<double>>> columns_{db::read_columns().size()};
  std::vector<lab::SecondOrderWorkPoint> work_;
  bool has_work_ = false;
  std::optional<lab::FaultySpans> health_;  ///< of a test with findings about its sensors
  std::int64_t next_of_health_ = 0;
  std::vector<Fault> faults_;
  std::vector<std::int64_t> unread_steps_;
};

}  // namespace triax::study
