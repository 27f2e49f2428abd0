// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/element/figures/path_figure.hpp"

#include <fmt/format.h>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

#include "src/plot/axes.hpp"
#include "src/plot/log_axis.hpp"
#include "src/plot/note.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"

namespace triax::src {
namespace {

constexpr int kPathWidth = 900, kPathRow = 300;

struct Plane {
  std::string x, y, x_title, y_title;
  double x_unit = 1, y_unit = 1;
  double least = 0;  ///< that y has to move by, in the unit of its axis
  bool logarithmic = false;
};

Points points_in(const study::PathResult& path, const Plane& plane) {
  Points points;
  for (const auto& row : path.rows) {
    const auto x = path.value(row, plane.x), y = path.value(row, plane.y);
    if (x && y && (!plane.logarithmic || *x > 0))
      points.emplace_back(*x * plane.x_unit, *y * plane.y_unit);
  }
  RangeOf range;
  for (const auto& p : points) range.add(p.y());
  if (points.size() < 2 || range.width() < plane.least) points.clear();
  return points;
}

void draw_plane(QCPAxisRect& rect, const Plane& plane, const Points& points, const QPointF* peak) {
  style_axes(rect, plane.x_title, plane.y_title);
  RangeOf x, y;
  for (const auto& p : points) x.add(p.x()), y.add(p.y());
  auto* across = rect.axis(QCPAxis::atBottom);
  if (plane.logarithmic) {
    double low = points.front().x(), high = low;
    for (const auto& p : points) low = std::min(low, p.x()), high = std::max(high, p.x());
    set_log_axis(*across, low, high);
  } else {
    x.add(0);
    if (plane.y != std::string_view("pore_pressure_kPa")) y.add(0);  // on top of a back pressure
    across->setRange(x.with_margin(0.04, true));
  }
  rect.axis(QCPAxis::atLeft)->setRange(y.with_margin(0.08, true));
  draw_curve(rect, points, line(kBlue, 1.8));
  if (peak != nullptr)
    draw_markers(rect, {*peak}, {QCPScatterStyle::ssSquare, line(kInk, 1.6), QBrush(Qt::white), 9});
}

FigureData data_of(const study::PathResult& path, const std::string& title) {
  FigureData data{.title = title,
                  .origin = "simulated",
                  .remarks = {"material: " + path.material.name},
                  .columns = {},
                  .rows = {}};
  for (const auto& column : path.columns) data.columns.push_back({column, ""});
  for (const auto& row : path.rows) data.rows.push_back(row.values);
  return data;
}

}  // namespace

NamedFigure path_figure(const study::PathResult& path) {
  const std::vector<Plane> planes = {
      {"axial_strain", "q_kPa", "ε₁ (%)", "q (kPa)", 100},
      {"p_eff_kPa", "q_kPa", "p′ (kPa)", "q (kPa)"},
      {"axial_strain", "volumetric_strain", "ε₁ (%)", "ε_v (%)", 100, 100, 1e-3},
      {"axial_strain", "pore_pressure_kPa", "ε₁ (%)", "u (kPa)", 100, 1, 1e-3},
      {"p_eff_kPa", "void_ratio", "p′ (kPa)", "void ratio e", 1, 1, 1e-6, true}};
  std::vector<std::pair<const Plane*, Points>> drawn;
  for (const auto& plane : planes)
    if (auto points = points_in(path, plane); !points.empty())
      drawn.emplace_back(&plane, std::move(points));
  const std::string caption =
      fmt::format("Path \"{}\" of one material point of {}.", path.name, path.material.name);
  NamedFigure figure{"path", {nullptr, caption}, data_of(path, caption)};
  if (drawn.empty()) return figure;
  const int count = static_cast<int>(drawn.size());
  const int columns = count == 4 ? 2 : std::min(count, 3);  // no half of a row is empty
  auto plot = make_plot(kPathWidth, kPathRow * ((count + columns - 1) / columns) + kNoteHeight);
  const auto rects = add_axes_in_rows(*plot, count, columns);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const auto& [plane, points] = drawn[i];
    QPointF at;
    const QPointF* peak = nullptr;
    if (path.peak && plane->y == "q_kPa") {
      const auto x = path.value(*path.peak, plane->x), y = path.value(*path.peak, plane->y);
      if (x && y) {
        at = {*x * plane->x_unit, *y * plane->y_unit};
        peak = &at;
      }
    }
    draw_plane(*rects[i], *plane, points, peak);
  }
  note_below(*plot, fmt::format("simulated: {}, {}{}", path.name, path.material.name,
                                path.peak ? ", square: largest |q|" : ""));
  figure.drawing.plot = std::move(plot);
  return figure;
}

}  // namespace triax::src
