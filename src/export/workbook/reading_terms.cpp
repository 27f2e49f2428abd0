// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/reading_terms.hpp"

#include <algorithm>

#include "sim/mechanics/units.hpp"

namespace triax::src {

Term ReadingTerms::of(lab::Quantity quantity, const lab::Reading& reading, std::size_t row) const {
  const auto found = std::ranges::find(header_.columns, quantity);
  if (found == header_.columns.end() || !reading.has(quantity)) return {};
  const auto column =
      static_cast<std::size_t>(found - header_.columns.begin()) + (header_.has_time ? 2 : 1);
  const sim::Unit unit = *sim::find_unit(lab::info(quantity).unit);
  const Term field =
      cell(on_sheet(kReadingsSheet, column, row + below_), sim::to_field(reading[quantity], unit));
  return unit.scale == 1 ? field : times(field, constant(unit.scale));
}

}  // namespace triax::src
