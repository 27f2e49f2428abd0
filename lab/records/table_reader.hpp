// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "lab/base/line_reader.hpp"
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
  double test = kMissing;  ///< number of the test, from a column that names it
  std::int64_t line = 0;
};

/// Draws the rows of a recognised table from the first to the last, in constant memory.
class TableReader {
 public:
  /// All three must outlive the reader. Starts at the first row whatever was read before.
  TableReader(ByteSource& source, const TableLayout& layout, Findings& findings);

  /// The next row; false at the end. Throws BadInput "FILE:LINE: ..." on text in a number, a clock
  /// in another format than the column's, a wrong number of cells, an infinite value, a raw channel
  /// beyond what any instrument measures, a word for a missing value where the dialect has none, a
  /// file that ends inside a row. A code for "no value" (lab/intake/cells/fill_values.hpp) is a
  /// missing cell, in every dialect. Missing cells, lines without values, an unclear last line and
  /// columns that contradict each other are noted as findings.
  bool next(Row& row);

  std::uint64_t position() const { return lines_.position(); }
  /// Names of stages whose column holds words, in the order in which they came: that of stage 1
  /// first.
  const std::vector<std::string>& stage_names() const { return stage_names_.all(); }
  /// Text of the last row in the column that names the tests; empty without such a column.
  std::string test_name() const;
  TableReader(const TableReader&) = delete;
  TableReader& operator=(const TableReader&) = delete;
  /// Comment lines met since the first row, without their mark, one text line a file line.
  const std::string& trailer() const { return trailer_; }
  /// Line of the file in which trailer() begins.
  std::int64_t trailer_line() const { return trailer_line_; }

 private:
  enum Slot : std::size_t {
    kTime = kQuantityCount,
    kStageTime,
    kStage,
    kTest,
    kFirstSource,
    kUnwanted = kFirstSource + kSourceCount
  };
  /// Words as numbers from 1, in the order in which they come.
  class WordNumbers {
   public:
    double of(std::string_view word);
    const std::vector<std::string>& all() const { return words_; }

   private:
    std::vector<std::string> words_;
    std::map<std::string, double, std::less<>> numbers_;
  };
  struct Plan {
    std::size_t slot = kUnwanted;
    double scale = 1;
    const PlannedColumn* column = nullptr;
    std::string missing, code;                               // kinds of finding
    double limit = std::numeric_limits<double>::infinity();  // of the absolute value, in SI
    bool is_compared = false;                                // with other columns
    double last_before_code = kMissing;                      // as printed
    bool has_clock = false;                                  // column->clock has the format
    WordNumbers* words = nullptr;                            // of a column that holds words
  };

  bool parse_fast(std::string_view line);
  bool parse_general(std::string_view text);
  void check_limit(std::string_view cell, const Plan& plan) const;
  void parse_number(std::string_view cell, Plan& plan);
  bool skip_clock(const char*& at, const char* end, const Plan& plan);
  void parse_clock(std::string_view cell, const Plan& plan);
  void keep_clock(const ClockTime& time, const Plan& plan);
  void finish_clock();
  void keep_missing(std::string_view cell, const Plan& plan);
  [[noreturn]] void refuse_text(std::string_view cell, const Plan& plan) const;
  void keep_word(std::string_view cell, const Plan& plan);
  /// Number in the file of the line that is read.
  std::int64_t line() const;
  double previous(Plan& plan) const;
  bool parse_code(std::string_view cell, Plan& plan, double number);
  /// "5%" of a quantity that is a plain number, whatever its heading's unit: 0.05.
  bool parse_percent(std::string_view cell, const Plan& plan);
  bool parse_remark(std::string_view cell, const Plan& plan);
  bool is_beside_block();
  void check_cell_count(std::string_view text);
  void keep_printed(std::string_view cell, const Plan& plan);
  bool skipped(std::string_view text);
  void keep_comment(std::string_view text);
  void complete(Row& row);

  const TableLayout& layout_;
  Findings& findings_;
  LineReader lines_;
  std::vector<Plan> plan_;
  std::vector<std::string_view> cells_;
  ColumnConsistency consistency_;
  RowCompletion completion_;
  std::array<PrintedValue, kQuantityCount> printed_{};  ///< of the columns that are compared
  using Values = std::array<double, kUnwanted + 1>;
  std::array<Values, 2> rows_{};  ///< this row and the one before, in turn
  std::size_t now_ = 0;           ///< which of the two is this row
  DecimalMark decimal_;
  char separator_;
  bool has_clock_ = false;  ///< the time is from clocks
  bool has_date_ = false;   ///< with the date from a column of its own
  bool has_time_of_day_ = false;
  Clock clock_;
  ClockTime row_clock_;  ///< of this row
  WordNumbers stage_names_, test_names_;
  std::int64_t blank_line_ = 0;
  std::string trailer_;
  std::int64_t trailer_line_ = 0;
};

}  // namespace triax::lab
