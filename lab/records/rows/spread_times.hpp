// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <exception>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "lab/records/findings.hpp"
#include "lab/records/table_reader.hpp"

namespace triax::lab {

/// Spreads the times (s) of rows that repeat a time of a rounded clock evenly up to the next time:
/// 10, 10, 11 becomes 10, 10.5, 11. Reads ahead to the next time, by kMaxRows rows at most.
///
/// The time within the stage is spread if the record has one, otherwise the time of the test. Rows
/// are returned unchanged if no later time of the same stage follows. Each repeated time is a
/// finding. Failures of the source are thrown after the rows before them were returned.
class SpreadTimes {
 public:
  static constexpr std::size_t kMaxRows = 1000;

  SpreadTimes(std::function<bool(Row&)> source, bool has_stage_time, Findings& findings)
      : source_(std::move(source)), has_stage_time_(has_stage_time), findings_(findings) {}

  bool next(Row& row);

 private:
  double& time_of(Row& row) const { return has_stage_time_ ? row.stage_time_s : row.time_s; }
  bool is_repeated(Row& row);
  std::optional<Row> read();
  void read_group();
  void spread(double next_time_s);

  std::function<bool(Row&)> source_;
  bool has_stage_time_;
  Findings& findings_;
  std::vector<Row> group_;        ///< rows of one time
  std::size_t returned_ = 0;      ///< of them
  std::optional<Row> following_;  ///< the first row after them
  std::exception_ptr failure_;    ///< of the source, after them
};

}  // namespace triax::lab
