// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

#include "lab/records/rows/row_order.hpp"
#include "lab/records/rows/row_spacing.hpp"
#include "lab/records/rows/test_restart.hpp"

namespace triax::lab {

/// The rows of a record as one sequence, as the file has them: that they are of one test
/// (TestRestart), in their order (RowOrder) and complete (RowSpacing).
class RowSequence {
 public:
  explicit RowSequence(const TableLayout& layout);

  /// Processes the next row. Throws SeveralTests as TestRestart::add.
  void add(const Row& row, Findings& findings);
  /// The record is over. Throws BadInput as RowOrder::finish.
  void finish(Findings& findings) const;

 private:
  bool has_time_;
  std::int64_t rows_ = 0;
  double stage_ = kMissing;  ///< as in the file; missing where it has none
  TestRestart test_restart_;
  RowOrder row_order_;
  RowSpacing row_spacing_;
};

}  // namespace triax::lab
