// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <exception>
#include <functional>
#include <utility>
#include <vector>

#include "lab/records/findings.hpp"
#include "lab/records/table_reader.hpp"

namespace triax::lab {

/// Spreads the times (s) of rows that repeat a time of a rounded clock evenly up to the next time:
/// 10, 10, 11 becomes 10, 10.5, 11. Reads ahead to the next time, by kMaxRows rows at most.
///
/// The time within the stage is spread if the record has one, otherwise the time of the test. If no
/// later time of the same stage follows and the time before was repeated, too, the rows are spread
/// at the distance of the rows before them, at most over the time that those took; else they are
/// returned unchanged. Each repeated time is a finding. Failures of the source are thrown after the
/// rows before them were returned.
class SpreadTimes {
 public:
  static constexpr std::size_t kMaxRows = 1000;

  SpreadTimes(std::function<bool(Row&)> source, bool has_stage_time, Findings& findings)
      : source_(std::move(source)), has_stage_time_(has_stage_time), findings_(findings) {}
  SpreadTimes(const SpreadTimes&) = delete;
  SpreadTimes& operator=(const SpreadTimes&) = delete;

  /// The next row, until the next call; null at the end.
  Row* next();

 private:
  double& time_of(Row& row) const { return has_stage_time_ ? row.stage_time_s : row.time_s; }
  bool is_repeated(Row& first);
  void read_following();
  void read_group(const Row& first);
  void end_time(Row& first, std::size_t count);
  void spread(double next_time_s);

  std::function<bool(Row&)> source_;
  bool has_stage_time_;
  Findings& findings_;
  std::vector<Row> group_;    ///< rows of one repeated time
  std::size_t returned_ = 0;  ///< of them
  double step_s_ = 0;         ///< between the last two times
  std::size_t before_ = 0;    ///< rows of the time before
  std::array<Row, 2> rows_;   ///< for the two that follow
  Row* current_ = rows_.data();
  Row* following_ = rows_.data() + 1;  ///< the first row after them
  bool has_following_ = false;         ///< false before the first row and at the end
  bool has_begun_ = false;
  std::exception_ptr failure_;  ///< of the source, after them
};

}  // namespace triax::lab
