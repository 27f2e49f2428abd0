// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/work_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace triax::src {
namespace {

constexpr int kSeven = lab::BlockPyramid::kBlocks;
constexpr std::size_t kColumnsOfLevel = kBlockSignals + 1;  // one stays empty
constexpr std::size_t kFirstBlockRow = kFirstRow + 1;

/// Three products, counted from nought: formulas of sums that no difference of large numbers is in.
struct Fit {
  Term slope, curvature;
};

Fit fit_of(const std::array<Term, kSeven>& y) {
  double first = 0, second = 0;
  for (int b = 0; b < kSeven; ++b) {
    const double i = b - 3, above = y[static_cast<std::size_t>(b)].value - y[3].value;
    first += i * above;
    second += (i * i - 4) * above;
  }
  const auto gap = [&](std::size_t a, std::size_t b) { return difference(y[a], y[b]).text; };
  return {{first / 28, fmt::format("SUM({},2*{},3*{})/28", gap(4, 2), gap(5, 1), gap(6, 0)), true},
          {second / 84,
           fmt::format("SUM(5*{},5*{},-3*{},-3*{})/84", gap(0, 3), gap(6, 3), gap(2, 3), gap(4, 3)),
           true}};
}

Term square_root(const Term& a) {
  return function("SQRT", a, [](double x) { return std::sqrt(x); });
}

}  // namespace

WorkCells::WorkCells(const WorkWindows& windows, const lab::RecordHeader& header,
                     std::size_t state_columns)
    : windows_(windows), has_time_(header.has_time), before_(state_columns) {
  for (const WorkWindow& window : windows.windows()) top_ = std::max(top_, window.level);
}

Term WorkCells::block(int level, std::size_t index, std::size_t signal) const {
  const double value = windows_.blocks(level)[index][signal];
  if (level > 0)
    return cell(
        on_sheet(kBlocksSheet, static_cast<std::size_t>(level - 1) * kColumnsOfLevel + signal,
                 kFirstBlockRow + index),
        value);
  const auto own = [&](StateCell place) { return before_ + static_cast<std::size_t>(place); };
  constexpr std::size_t kTimeColumn = 1;
  const std::array<std::size_t, kBlockSignals> columns{
      has_time_ ? kTimeColumn : own(StateCell::axial_strain_path), own(StateCell::q_pa),
      own(StateCell::p_eff_pa), kAxialStrainColumn, own(StateCell::specimen_volumetric_strain)};
  return cell(on_sheet(kStatesSheet, columns[signal], windows_.row(index)), value);
}

Term WorkCells::slope(const WorkWindow& window, BlockSignal signal) const {
  std::array<Term, kSeven> blocks;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    blocks[b] = block(window.level, window.first + b, static_cast<std::size_t>(signal));
  const Fit fit = fit_of(blocks);
  if (window.offset == 0) return fit.slope;
  return sum(fit.slope, times(constant(2.0 * window.offset), fit.curvature));
}

void WorkCells::keep(const WorkWindow& window, StateTerms& row) const {
  const Term progress =
      row.keep(StateCell::progress_of_block, slope(window, BlockSignal::progress));
  const auto rate = [&](StateCell place, BlockSignal signal) {
    const Term of_block = slope(window, signal);
    return row.keep(place,
                    progress.value > 0 ? times(of_block, over(constant(1), progress)) : of_block);
  };
  const Term q = rate(StateCell::q_rate, BlockSignal::q);
  const Term p = rate(StateCell::p_rate, BlockSignal::p_eff);
  const Term axial = rate(StateCell::axial_rate, BlockSignal::axial_strain);
  const Term volumetric = rate(StateCell::volumetric_rate, BlockSignal::volumetric_strain);
  const Term two = constant(2), three = constant(3);
  const Term stress_1 = row.keep(StateCell::axial_stress_rate, sum(p, over(times(two, q), three)));
  const Term stress_3 = row.keep(StateCell::radial_stress_rate, difference(p, over(q, three)));
  const Term strain_3 =
      row.keep(StateCell::radial_strain_rate, over(difference(volumetric, axial), two));
  const auto dot = [&](const Term& a1, const Term& b1, const Term& a3, const Term& b3) {
    return sum(times(a1, b1), times(times(two, a3), b3));
  };
  const Term work = row.keep(StateCell::work, dot(stress_1, axial, stress_3, strain_3));
  const Term norms = times(square_root(dot(stress_1, stress_1, stress_3, stress_3)),
                           square_root(dot(axial, axial, strain_3, strain_3)));
  const Term ratio = over(work, norms);
  const std::string bounded = "MAX(-1,MIN(1," + ratio.text + "))";
  if (norms.value > 0)
    row.keep(StateCell::work_normalised, {std::clamp(ratio.value, -1.0, 1.0), bounded, false});
  else
    row.keep(StateCell::work_normalised, {0, "IF(" + norms.text + ">0," + bounded + ",0)", false});
}

void WorkCells::write_blocks(Sheet& sheet) const {
  const char* const headings[] = {has_time_ ? "time_s" : "axial_strain_path", "q_Pa", "p_eff_Pa",
                                  "axial_strain", "volumetric_strain"};
  const auto column_of_level = [](int level) {
    return static_cast<std::size_t>(level - 1) * kColumnsOfLevel;
  };
  for (int level = 1; level <= top_; ++level)
    sheet.text(kHeadingRow, column_of_level(level),
               fmt::format("means of {} readings", std::int64_t{1} << level), Look::heading);
  for (int level = 1; level <= top_; ++level)
    for (std::size_t k = 0; k < kBlockSignals; ++k)
      sheet.text(kFirstRow, column_of_level(level) + k, headings[k], Look::heading);
  const std::size_t rows = top_ > 0 ? windows_.blocks(1).size() : 0;
  for (std::size_t i = 0; i < rows; ++i)
    for (int level = 1; level <= top_ && i < windows_.blocks(level).size(); ++level) {
      const std::size_t half = windows_.first_half(level, i);
      for (std::size_t k = 0; k < kBlockSignals; ++k)
        sheet.formula(kFirstBlockRow + i, column_of_level(level) + k,
                      mean(block(level - 1, half, k), block(level - 1, half + 1, k)),
                      windows_.blocks(level)[i][k]);
    }
}

}  // namespace triax::src
