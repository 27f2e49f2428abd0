// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/collapse_points_figure.hpp"

#include <fmt/format.h>

#include <map>

#include "src/plot/plot_style.hpp"
#include "src/plot/point_labels.hpp"
#include "src/plot/shapes.hpp"
#include "src/plot/stress_lines.hpp"
#include "src/triaxial/figures/origin_note.hpp"
#include "src/triaxial/figures/programme_looks.hpp"

namespace triax::src {
namespace {

constexpr int kCollapsePointsWidth = 720;
constexpr int kCollapsePointsHeight = 520 + kNoteHeight;

QPointF place(const study::CollapsePoint& point) {
  return {point.stress.p_pa * 1e-3, point.stress.q_pa * 1e-3};
}

void draw_points(QCustomPlot& plot, const study::CollapsePoints& found) {
  const auto& points = found.points;
  std::vector<std::string> programmes;
  for (const auto& point : points) programmes.push_back(point.programme);
  const ProgrammeLooks looks(programmes);
  std::map<std::string, QCPCurve*> groups;
  std::vector<PointLabel> labels;
  for (const auto& point : points) {
    const auto name = point.programme + (point.simulated ? " (simulated)" : " (recorded)");
    auto& group = groups[name];
    if (group == nullptr)
      group =
          draw_markers(*plot.axisRect(), {}, looks.marker(point.programme, point.simulated), name);
    const QPointF at = place(point);
    group->addData(at.x(), at.y());
    labels.push_back({at.x(), at.y(), point.test, kInk});
  }
  legend_below(plot, 2);
  note_below(plot, origin_note(found.origin));
  place_labels(plot, labels);
}

}  // namespace

Drawing collapse_points_figure(const study::CollapsePoints& found) {
  const auto& points = found.points;
  if (found.instability_lines.empty()) return {};
  RangeOf p_range, q_range;
  p_range.add(0);
  q_range.add(0);
  for (const auto& point : points) {
    p_range.add(place(point).x());
    q_range.add(place(point).y());
  }
  auto plot = make_plot(kCollapsePointsWidth, kCollapsePointsHeight);
  style_axes(*plot->axisRect(), "mean effective stress p′ (kPa)", "deviator stress q (kPa)");
  plot->xAxis->setRange(p_range.with_margin(0.12, true));
  plot->yAxis->setRange(q_range.with_margin(0.35, true));
  draw_mohr_coulomb_lines(*plot, found.limit_stress_ratios);
  for (const double eta : found.instability_lines) draw_instability_line(*plot, eta);
  draw_points(*plot, found);
  return {std::move(plot), fmt::format("Collapse points of {} test{} and {} best ({}).",
                                       points.size(), points.size() == 1 ? "" : "s",
                                       found.instability_lines.size() == 1
                                           ? "the one instability line that fits them"
                                           : "the instability lines that fit them",
                                       instability_words(found.instability_lines))};
}

}  // namespace triax::src
