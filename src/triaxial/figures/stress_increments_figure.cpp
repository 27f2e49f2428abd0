// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/stress_increments_figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/plot/axes.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/point_labels.hpp"
#include "src/plot/shapes.hpp"
#include "src/triaxial/figures/origin_note.hpp"
#include "src/triaxial/figures/programme_looks.hpp"

namespace triax::src {
namespace {

constexpr int kStressIncrementsWidth = 720, kStressIncrementsHeight = 470 + kNoteHeight;
constexpr double kArrow = 30;  // px

QPointF place(const study::CollapseIncrement& at) { return {at.p_pa * 1e-3, at.q_pa * 1e-3}; }

std::string caption(const std::vector<study::CollapseIncrement>& increments) {
  const auto [lowest, highest] = study::direction_range(increments);
  return fmt::format(
      "Stress increments of {} test{} at collapse. Isotropic unloading, dq = 0 and dp′ < 0, points "
      "to the left; these lie between {:.0f}° and {:+.0f}° of it.",
      increments.size(), increments.size() == 1 ? "" : "s", lowest, highest);
}

}  // namespace

Drawing stress_increments_figure(const std::vector<study::CollapseIncrement>& increments,
                                 const std::string& origin) {
  if (increments.empty()) return {};
  std::vector<std::string> programmes;
  RangeOf p, q;
  p.add(0);
  q.add(0);
  for (const auto& at : increments) {
    programmes.push_back(at.programme);
    p.add(place(at).x());
    q.add(place(at).y());
  }
  const ProgrammeLooks looks(programmes);
  auto plot = make_plot(kStressIncrementsWidth, kStressIncrementsHeight);
  auto& rect = *plot->axisRect();
  style_axes(rect, "mean effective stress p′ (kPa)", "deviator stress q (kPa)");
  for (const auto& name : looks.names())
    draw_markers(rect, {}, looks.marker(name, !origin.empty()), name + ": state and increment");
  legend_below(*plot, 3);
  note_below(*plot, origin);
  set_equal_ranges(rect, p.with_margin(0.14, true), q.with_margin(0.20, true));
  plot->xAxis->setRange(0, plot->xAxis->range().size());
  plot->yAxis->setRange(0, plot->yAxis->range().size());
  plot->replot();
  const double unit = plot->xAxis->range().size() / rect.width();  // kPa a pixel
  std::vector<PointLabel> labels;
  for (const auto& at : increments) {
    const double size = std::hypot(at.dp, at.dq);
    const QPointF tip = place(at) + kArrow * unit / size * QPointF(at.dp, at.dq);
    draw_arrow(rect, place(at), tip, line(looks.colour(at.programme), 1.6));
    draw_markers(rect, {place(at)}, looks.marker(at.programme, !origin.empty()));
    labels.push_back({place(at).x(), place(at).y(), at.test, kInk});
  }
  place_labels(*plot, labels);
  return {std::move(plot), caption(increments)};
}

}  // namespace triax::src
