// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Charts of shear over the cells of the states.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "db/store.hpp"
#include "src/export/workbook/book.hpp"
#include "src/study/triaxial/line_breaks.hpp"

namespace triax::src {

/// Rows that one line of a chart goes through; dotted where nothing was read between two of them.
struct RowRange {
  std::size_t first = 0, last = 0;
  bool dotted = false;
};

/// The lines of one chart, row by row; they end where a sensor could not be believed.
class ChartLines {
 public:
  /// `join`: to the last row that was added.
  void add(std::size_t row, study::Join join);
  const std::vector<RowRange>& ranges() const { return ranges_; }

 private:
  std::vector<RowRange> ranges_;
};

/// First and last row of shear on the states' sheet, the lines of the charts in their order, and
/// the pore pressures between them, in kPa; empty where none is known.
struct ShearRows {
  std::size_t first = 0, last = 0;
  std::optional<std::pair<double, double>> pore_kPa{};
  ChartLines q, path, pore, volume;
  void add_pore(double kPa) {
    if (!std::isfinite(kPa)) return;
    if (!pore_kPa) pore_kPa = {kPa, kPa};
    pore_kPa = {std::min(pore_kPa->first, kPa), std::max(pore_kPa->second, kPa)};
  }
};

/// Step of an axis over these values: 1, 2 or 5 times a power of ten.
double axis_step(double low, double high);
/// Ends of the axis, at whole steps: a back pressure of some hundred kPa shall not flatten what
/// moved on top of it.
std::pair<double, double> axis_ends(double low, double high);

/// q over ε₁, q over p′, u over ε₁ where it is known and the drainage was closed, else ε_v, and
/// normalised second-order work over ε₁. `title` is that of each chart's test.
void write_charts(Book& book, Sheet& sheet, const ShearRows& rows, bool pore_pressure,
                  const std::string& title);

}  // namespace triax::src
