// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/calibrate/calibrate_figures.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

#include "src/calibrate/implied_domain_figure.hpp"
#include "src/plot/axes.hpp"
#include "src/plot/note.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"

namespace triax::src {
namespace {

using study::Imposed;
using study::PathKnot;

constexpr int kWidth = 1060, kHeight = 480;

using KnotValue = double (*)(const PathKnot&);
double strain_in_percent(const PathKnot& k) { return 100 * k.axial_strain; }
double volume_in_percent(const PathKnot& k) { return 100 * k.volumetric_strain; }
double mean_stress_kPa(const PathKnot& k) { return k.p_eff / 1e3; }
double deviator_kPa(const PathKnot& k) { return k.q / 1e3; }

struct Plane {
  KnotValue x, y;
  const char *x_title, *y_title;
};
struct Kind {
  Imposed imposed;
  const char* name;
  Plane left, right;
};

constexpr const char *kStrain = "axial strain ε₁ (%)", *kVolume = "volumetric strain ε_v (%)",
                     *kMean = "mean effective stress p′ (kPa)",
                     *kDeviator = "deviator stress q (kPa)";

const std::array<Kind, 3> kKinds = {{{Imposed::undrained,
                                      "undrained",
                                      {strain_in_percent, deviator_kPa, kStrain, kDeviator},
                                      {mean_stress_kPa, deviator_kPa, kMean, kDeviator}},
                                     {Imposed::drained,
                                      "drained",
                                      {strain_in_percent, deviator_kPa, kStrain, kDeviator},
                                      {strain_in_percent, volume_in_percent, kStrain, kVolume}},
                                     {Imposed::stress_path,
                                      "stress_path",
                                      {mean_stress_kPa, strain_in_percent, kMean, kStrain},
                                      {mean_stress_kPa, volume_in_percent, kMean, kVolume}}}};

Points points_of_knots(const PathKnot& start, const std::vector<PathKnot>& knots,
                       const Plane& plane) {
  Points points = {QPointF(plane.x(start), plane.y(start))};
  for (const PathKnot& k : knots) points.emplace_back(plane.x(k), plane.y(k));
  return points;
}

void fill_plane(QCPAxisRect& rect, const study::Calibration& c, const Kind& kind,
                const Plane& plane, bool named) {
  style_axes(rect, plane.x_title, plane.y_title);
  RangeOf x, y;
  std::size_t number = 0;
  for (std::size_t t = 0; t < c.measured.size(); ++t) {
    const auto& path = c.measured[t];
    if (path.imposed != kind.imposed) continue;
    const Points measured = points_of_knots(path.start, path.knots, plane);
    for (const QPointF& point : measured) x.add(point.x()), y.add(point.y());
    const QPen pen = curve_pen(number++);
    draw_markers(rect, measured,
                 {QCPScatterStyle::ssCircle, line(pen.color(), 0.8), Qt::NoBrush, 4});
    const Points computed = points_of_knots(path.start, c.computed[t].knots, plane);
    for (const QPointF& point : computed) y.add(point.y());
    draw_curve(rect, computed, pen, named ? path.name : std::string());
  }
  rect.axis(QCPAxis::atBottom)->setRange(x.with_margin(0.04, true));
  rect.axis(QCPAxis::atLeft)->setRange(y.with_margin(0.06, true));
}

FigureData data_of_kind(const study::Calibration& c, const Kind& kind) {
  FigureData data{.title = fmt::format("{} tests and the calibrated law", kind.name),
                  .origin = "recorded",
                  .remarks = {"law: " + c.material.law->name,
                              "test is the number of a test in the order of these remarks"},
                  .columns = {{"test", ""},
                              {"axial_strain", ""},
                              {"q_kPa", "kPa"},
                              {"p_eff_kPa", "kPa"},
                              {"volumetric_strain", ""},
                              {"computed_axial_strain", ""},
                              {"computed_q_kPa", "kPa"},
                              {"computed_p_eff_kPa", "kPa"},
                              {"computed_volumetric_strain", ""}},
                  .rows = {}};
  double number = 0;
  for (std::size_t t = 0; t < c.measured.size(); ++t) {
    const auto& path = c.measured[t];
    if (path.imposed != kind.imposed) continue;
    if (path.simulated) data.origin = "simulated";
    data.remarks.push_back(fmt::format("test {:g}: {}", ++number, path.name));
    for (std::size_t k = 0; k < path.knots.size(); ++k) {
      const PathKnot& m = path.knots[k];
      data.rows.push_back({number, m.axial_strain, m.q / 1e3, m.p_eff / 1e3, m.volumetric_strain});
      data.rows.back().resize(data.columns.size());
      if (k >= c.computed[t].knots.size()) continue;
      const PathKnot& f = c.computed[t].knots[k];
      auto& row = data.rows.back();
      row[5] = f.axial_strain, row[6] = f.q / 1e3, row[7] = f.p_eff / 1e3;
      row[8] = f.volumetric_strain;
    }
  }
  return data;
}

Drawing drawing_of(const study::Calibration& c, const Kind& kind) {
  auto plot = make_plot(kWidth, kHeight);
  auto& left = *plot->axisRect();
  auto& right = add_axes_beside(*plot);
  fill_plane(left, c, kind, kind.left, true);
  fill_plane(right, c, kind, kind.right, false);
  legend_below(*plot, 6);
  note_below(*plot, fmt::format("points: measured, lines: {}, calibrated{}", c.material.law->name,
                                c.interrupted ? " (interrupted)" : ""));
  return {std::move(plot), fmt::format("Measured {} tests (points) and the calibrated law (lines).",
                                       study::to_string(kind.imposed))};
}

}  // namespace

std::vector<NamedFigure> calibrate_figures(const study::Calibration& c) {
  std::vector<NamedFigure> figures;
  for (const Kind& kind : kKinds) {
    FigureData data = data_of_kind(c, kind);
    if (!data.rows.empty()) figures.push_back({kind.name, drawing_of(c, kind), std::move(data)});
  }
  if (c.domain && c.domain->none.empty()) figures.push_back(implied_domain_figure(c));
  return figures;
}

}  // namespace triax::src
