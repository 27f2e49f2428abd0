// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "lab/base/line_reader.hpp"
#include "lab/records/cells/clock_time.hpp"
#include "lab/records/column_consistency.hpp"
#include "lab/records/table_layout.hpp"
#include "lab/results/reading.hpp"

namespace triax::lab {

/// One row of a record as the file has it, in SI; what the file does not hold is NaN.
struct Row {
  std::array<double, kQuantityCount> si{};
  double time_s = kMissing;
  double stage_time_s = kMissing;
  double stage = kMissing;
  std::int64_t line = 0;
};

/// Draws the rows of a recognised table from the first to the last, in constant memory.
class TableReader {
 public:
  /// All three must outlive the reader. Starts at the first row whatever was read before.
  TableReader(ByteSource& source, const TableLayout& layout, Findings& findings);

  /// The next row; false at the end. Throws BadInput "FILE:LINE: ..." on text in a number, a wrong
  /// number of cells, an infinite value, a raw channel beyond what any instrument measures, a word
  /// for a missing value where the dialect has none, a file that ends inside a row. A code for "no
  /// value" (no_value.hpp) is a missing cell, in every dialect. Missing cells, lines without
  /// values, an unclear last line and columns that contradict each other are noted as findings.
  bool next(Row& row);

  std::uint64_t position() const { return lines_.position(); }
  /// Comment lines met since the first row, without their mark, one text line a file line.
  const std::string& trailer() const { return trailer_; }
  /// Line of the file in which trailer() begins.
  std::int64_t trailer_line() const { return trailer_line_; }

 private:
  enum Slot : std::size_t { kTime = kQuantityCount, kStageTime, kStage, kUnwanted };
  struct Plan {
    std::size_t slot = kUnwanted;
    double scale = 1;
    const PlannedColumn* column = nullptr;
    std::string missing, code;                               // kinds of finding
    double limit = std::numeric_limits<double>::infinity();  // of the absolute value, in SI
    bool is_compared = false;                                // with other columns
    double last_before_code = kMissing;                      // as printed
  };

  bool parse_fast(std::string_view line);
  bool parse_general(std::string_view line);
  void check_limit(std::string_view cell, const Plan& plan) const;
  void parse_number(std::string_view cell, Plan& plan);
  double previous(Plan& plan) const;
  bool parse_code(std::string_view cell, Plan& plan, double number);
  /// "5%" of a quantity that is a plain number, whatever its heading's unit: 0.05.
  bool parse_percent(std::string_view cell, const Plan& plan);
  void check_cell_count(std::string_view line);
  void keep_printed(std::string_view cell, const Plan& plan);
  bool skipped(std::string_view line);
  void keep_comment(std::string_view line);

  const TableLayout& layout_;
  Findings& findings_;
  LineReader lines_;
  std::vector<Plan> plan_;
  std::vector<std::string_view> cells_;
  ColumnConsistency consistency_;
  std::array<PrintedValue, kQuantityCount> printed_{};  ///< of the columns that are compared
  using Values = std::array<double, kUnwanted + 1>;
  std::array<Values, 2> rows_{};  ///< this row and the one before, in turn
  std::size_t now_ = 0;           ///< which of the two is this row
  DecimalMark decimal_;
  char separator_;
  Clock clock_;
  std::int64_t blank_line_ = 0;
  std::string trailer_;
  std::int64_t trailer_line_ = 0;
};

}  // namespace triax::lab
