// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/charts_sheet.hpp"

#include <xlsxwriter.h>

#include <algorithm>
#include <array>

#include "src/export/workbook/layout.hpp"
#include "src/export/workbook/states_sheet.hpp"
#include "src/output/table.hpp"

namespace triax::src {
namespace {

struct ChartKind {
  const char* title;
  std::size_t x, y;
  const char *x_axis, *y_axis;
  const ChartLines* lines;  ///< null: points, of values that not every row has
  std::optional<std::pair<double, double>>
      ends{};  ///< of the axis of y; empty: chosen by who shows it
};

/// In Excel a chart has at most 255 series.
constexpr std::size_t kMaxSeries = 250;

lxw_chart_series* add_series(lxw_chart* chart, const ChartKind& kind, std::size_t first,
                             std::size_t last) {
  lxw_chart_series* const series = chart_add_series(chart, nullptr, nullptr);
  const auto from = static_cast<lxw_row_t>(first), to = static_cast<lxw_row_t>(last);
  const auto x = static_cast<lxw_col_t>(kind.x), y = static_cast<lxw_col_t>(kind.y);
  chart_series_set_categories(series, kStatesSheet, from, x, to, x);
  chart_series_set_values(series, kStatesSheet, from, y, to, y);
  return series;
}

/// One line of a look of its own, or several that look alike.
void add_lines(lxw_chart* chart, const ChartKind& kind) {
  const auto& ranges = kind.lines->ranges();
  for (std::size_t i = 0; i < std::min(ranges.size(), kMaxSeries); ++i) {
    lxw_chart_series* const series = add_series(chart, kind, ranges[i].first, ranges[i].last);
    if (ranges.size() == 1) return;
    lxw_chart_line line{};
    line.color = 0x0072B2;
    line.width = ranges[i].dotted ? 1.0F : 2.25F;
    if (ranges[i].dotted) line.dash_type = LXW_CHART_LINE_DASH_ROUND_DOT;
    chart_series_set_line(series, &line);
  }
}

void add_points(lxw_chart* chart, const ChartKind& kind, const ShearRows& rows) {
  lxw_chart_series* const series = add_series(chart, kind, rows.first, rows.last);
  chart_series_set_marker_type(series, LXW_CHART_MARKER_CIRCLE);
  chart_series_set_marker_size(series, 3);
}

void insert_chart(Book& book, Sheet& sheet, const ShearRows& rows, const ChartKind& kind,
                  const std::string& test, std::size_t row, std::size_t column) {
  lxw_chart* const chart = workbook_add_chart(
      book.get(), kind.lines == nullptr ? LXW_CHART_SCATTER : LXW_CHART_SCATTER_STRAIGHT);
  if (kind.lines == nullptr)
    add_points(chart, kind, rows);
  else if (kind.lines->ranges().empty())
    add_series(chart, kind, rows.first, rows.first);
  else
    add_lines(chart, kind);
  chart_title_set_name(chart, (test + ": " + kind.title).c_str());
  lxw_chart_font small{};
  small.size = 11;
  chart_title_set_name_font(chart, &small);
  chart_axis_set_name(chart->x_axis, kind.x_axis);
  chart_axis_set_name(chart->y_axis, kind.y_axis);
  chart_axis_set_label_position(chart->x_axis, LXW_CHART_AXIS_LABEL_POSITION_LOW);
  chart_axis_set_label_position(chart->y_axis, LXW_CHART_AXIS_LABEL_POSITION_LOW);
  if (kind.ends) {
    chart_axis_set_min(chart->y_axis, kind.ends->first);
    chart_axis_set_max(chart->y_axis, kind.ends->second);
    chart_axis_set_major_unit(chart->y_axis, axis_step(kind.ends->first, kind.ends->second));
  }
  chart_legend_set_position(chart, LXW_CHART_LEGEND_NONE);
  worksheet_insert_chart(sheet.get(), static_cast<lxw_row_t>(row), static_cast<lxw_col_t>(column),
                         chart);
}

}  // namespace

void ChartLines::add(std::size_t row, study::Join join) {
  if (ranges_.empty() || join == study::Join::none) {
    ranges_.push_back({row, row});
  } else if (join == study::Join::dotted) {
    ranges_.push_back({ranges_.back().last, row, true});
    ranges_.push_back({row, row});
  } else {
    ranges_.back().last = row;
  }
}

double axis_step(double low, double high) {
  constexpr double kSteps = 5;
  const double wanted = std::max(high - low, 1.0) / kSteps;
  double step = std::pow(10, std::floor(std::log10(wanted)));
  for (const double times : {2.0, 2.5, 2.0})
    if (step < wanted) step *= times;
  return step;
}

std::pair<double, double> axis_ends(double low, double high) {
  const double step = axis_step(low, high), from = std::floor(low / step);
  return {step * from, step * std::max(std::ceil(high / step), from + 1)};
}

void write_charts(Book& book, Sheet& sheet, const ShearRows& rows, bool pore_pressure,
                  const std::string& title) {
  constexpr std::size_t kStrain = 3, kVolume = 4, kPore = 9, kQ = 10, kP = 11;
  const std::string name = on_one_line(title).substr(0, 200);
  std::optional<std::pair<double, double>> pore;
  if (rows.pore_kPa) pore = axis_ends(rows.pore_kPa->first, rows.pore_kPa->second);
  const std::array<ChartKind, 4> kinds = {
      {{"deviator stress", kStrain, kQ, "axial strain", "q (kPa)", &rows.q},
       {"stress path", kP, kQ, "p′ (kPa)", "q (kPa)", &rows.path},
       pore_pressure
           ? ChartKind{"pore pressure", kStrain, kPore, "axial strain", "u (kPa)", &rows.pore, pore}
           : ChartKind{"volume", kStrain, kVolume, "axial strain", "volumetric strain",
                       &rows.volume},
       {"second-order work, normalised", kStrain, StatesSheet::column(StateCell::work_normalised),
        "axial strain", "W₂ (−1 to 1)", nullptr}}};
  for (std::size_t i = 0; i < kinds.size(); ++i)
    insert_chart(book, sheet, rows, kinds[i], name, kHeadingRow + 1 + 16 * (i / 2), 8 * (i % 2));
  worksheet_set_landscape(sheet.get());  // all four on one page
  worksheet_set_paper(sheet.get(), 9);   // A4
  worksheet_fit_to_pages(sheet.get(), 1, 1);
}

}  // namespace triax::src
