// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/table_layout.hpp"

#include <algorithm>
#include <utility>

namespace triax::lab {

bool TableLayout::has(ColumnRole role) const {
  return std::ranges::any_of(columns, [&](const PlannedColumn& column) {
    const bool is_clock = column.role == ColumnRole::date || column.role == ColumnRole::time_of_day;
    return column.role == role || (role == ColumnRole::time && is_clock);
  });
}

RowCompletion TableLayout::completion() const {
  std::vector<Quantity> measured;
  std::vector<SourceQuantity> sources;
  for (const PlannedColumn& column : columns) {
    if (column.role == ColumnRole::quantity) measured.push_back(column.quantity);
    if (column.role == ColumnRole::source) sources.push_back(column.source);
  }
  return {std::move(measured), sources, dialect.constants};
}

std::vector<Quantity> TableLayout::quantities() const { return completion().quantities(); }

}  // namespace triax::lab
