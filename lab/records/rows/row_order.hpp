// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "lab/intake/row_direction.hpp"
#include "lab/records/findings.hpp"
#include "lab/records/table_reader.hpp"

namespace triax::lab {

/// Finds rows that are not in the order in which they were measured, in constant memory. Each of
/// these is looked for; the last three only in a record without time, because TimeLine notes each
/// row in which the time runs back.
///
/// - All rows reversed (RowDirection): the time runs back, or without time the strain.
/// - Two rows that changed places: exchanged, they make the strain of six rows run forward. Of the
///   second differences, summed over the six, the exchange leaves a fraction, and the product of
///   those of strain and q is at most kSmooth_fraction. (Noise of one of them is no order.)
/// - A row out of place: after kRows_before rows that ran forward the strain runs back for one row
///   by kBack_steps of their mean step, and q turns with it. A row of unloading, with which q falls
///   and returns, is in its place.
class RowOrder {
 public:
  static constexpr double kSmooth_fraction = 0.1, kBack_steps = 3;
  static constexpr int kRows_before = 5;

  /// `file` is named in messages.
  explicit RowOrder(std::string file) : file_(std::move(file)) {}

  /// Processes the next row, as the file has it; `begins_stage` for the first of each stage.
  void add(const Row& row, bool begins_stage, Findings& findings);
  /// How it is known that all rows up to now are reversed; empty if they are not.
  std::string reversed() const;
  /// The record is over. Throws BadInput, with the first line, where all rows are reversed.
  void finish() const;

 private:
  struct Point {
    double strain = kMissing;  ///< distance from that of the first row
    double q = kMissing;
    std::int64_t line = 0;
  };
  bool changed_places() const;
  bool is_out_of_place();

  std::string file_;
  std::int64_t first_line_ = 0, last_line_ = 0;
  RowDirection time_, strain_;
  std::array<Point, 6> window_{};  ///< the latest rows, the last one last
  int forward_rows_ = 0;           ///< up to the last but two of the window
  double mean_step_ = 0;           ///< of them
};

}  // namespace triax::lab
