// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Second-order work as formulas: rates from parabolas through seven blocks of readings
// (lab/measured/local_fit.hpp), their work as in sim/mechanics/second_order_work.hpp, Eq. (23).
#include "src/export/workbook/book.hpp"
#include "src/export/workbook/reading_terms.hpp"
#include "src/export/workbook/work_windows.hpp"

namespace triax::src {

class WorkCells {
 public:
  /// States have so many columns before their own (StateCell).
  WorkCells(const WorkWindows& windows, const lab::RecordHeader& header, std::size_t state_columns);

  /// Rates and work of the window, as cells of the row.
  void keep(const WorkWindow& window, StateTerms& row) const;
  /// The means of blocks up to the level that some window needs.
  void write_blocks(Sheet& sheet) const;
  /// Where the sheet of blocks has any.
  bool has_blocks() const { return top_ > 0; }

 private:
  Term block(int level, std::size_t index, std::size_t signal) const;
  Term slope(const WorkWindow& window, BlockSignal signal) const;

  const WorkWindows& windows_;
  bool has_time_;
  std::size_t before_;
  int top_ = 0;  ///< level of the longest window
};

}  // namespace triax::src
