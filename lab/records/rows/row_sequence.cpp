// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/row_sequence.hpp"

#include <cmath>

namespace triax::lab {

RowSequence::RowSequence(const TableLayout& layout)
    : has_time_(layout.has(ColumnRole::time) || layout.has(ColumnRole::stage_time)),
      test_restart_(layout.file),
      row_order_(layout.file),
      row_spacing_(has_time_ ? "the time (s)" : "the axial strain") {}

void RowSequence::add(const Row& row, Findings& findings) {
  const bool changes_stage = !std::isnan(row.stage) && row.stage != stage_;
  const bool begins_stage = rows_ == 0 || changes_stage;
  if (changes_stage) stage_ = row.stage;
  ++rows_;
  test_restart_.add(row);
  row_order_.add(row, begins_stage, findings);
  const auto first_known = [](double a, double b) { return std::isnan(a) ? b : a; };
  row_spacing_.add(has_time_ ? first_known(row.time_s, row.stage_time_s)
                             : first_known(row.si[index(Quantity::axial_strain)],
                                           row.si[index(Quantity::axial_displacement)]),
                   row.line, begins_stage, findings);
}

void RowSequence::finish(Findings& findings) const {
  row_order_.finish();
  test_restart_.finish(findings);
}

}  // namespace triax::lab
