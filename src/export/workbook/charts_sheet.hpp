// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Charts of shear over the cells of the states.
#include "db/store.hpp"
#include "src/export/workbook/book.hpp"

namespace triax::src {

/// First and last row of shear on the states' sheet.
struct ShearRows {
  std::size_t first = 0, last = 0;
};

/// q over ε₁, q over p′, u over ε₁ where it is known and the drainage was closed, else ε_v, and
/// normalised second-order work over ε₁. `title` is that of each chart's test.
void write_charts(Book& book, Sheet& sheet, const ShearRows& rows, bool pore_pressure,
                  const std::string& title);

}  // namespace triax::src
