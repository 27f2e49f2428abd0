// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/stress_path_figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/plot/plot_style.hpp"
#include "src/plot/point_labels.hpp"
#include "src/plot/polyline.hpp"
#include "src/plot/shapes.hpp"
#include "src/plot/stress_lines.hpp"
#include "src/triaxial/figures/origin_note.hpp"

namespace triax::src {
namespace {

constexpr int kStressPathWidth = 620;
constexpr int kStressPathHeight = 460 + kNoteHeight;

QPointF place(const study::StressPoint& point) { return {point.p_pa * 1e-3, point.q_pa * 1e-3}; }

/// Those that are known, in kPa.
Points known(const std::vector<study::StressPoint>& path) {
  Points points;
  for (const auto& point : path)
    if (std::isfinite(point.p_pa) && std::isfinite(point.q_pa)) points.push_back(place(point));
  return points;
}

void add(RangeOf& p_range, RangeOf& q_range, const std::vector<study::StressPoint>& path) {
  for (const auto& point : path) {
    p_range.add(place(point).x());
    q_range.add(place(point).y());
  }
}

// The axes' ranges must be final.
void draw_path(QCustomPlot& plot, const Points& path, const std::string& name, const QPen& pen) {
  if (path.empty()) return;
  auto pixels = path;
  for (auto& point : pixels)
    point = {point.x() * kStressPathWidth / plot.xAxis->range().size(),
             point.y() * kStressPathHeight / plot.yAxis->range().size()};
  auto* curve = new QCPCurve(plot.xAxis, plot.yAxis);
  for (const auto i : points_to_draw(pixels, kInvisible)) curve->addData(path[i].x(), path[i].y());
  curve->setPen(pen);
  curve->setName(QString::fromStdString(name));
}

void mark(QCustomPlot& plot, const QPointF& at, QCPScatterStyle::ScatterShape shape,
          const QColor& colour, const std::string& name) {
  auto* point = new QCPCurve(plot.xAxis, plot.yAxis);
  point->addData(at.x(), at.y());
  point->setLineStyle(QCPCurve::lsNone);
  point->setScatterStyle(QCPScatterStyle(shape, line(colour, 1.8), QBrush(Qt::white), 10));
  point->setName(QString::fromStdString(name));
}

}  // namespace

Drawing stress_path_figure(const study::StressPath& path) {
  const Points before = known(path.before), shear = known(path.shear);
  if (before.empty() && shear.empty()) return {};
  RangeOf p_range, q_range;
  p_range.add(0);
  q_range.add(0);
  add(p_range, q_range, path.before);
  add(p_range, q_range, path.shear);

  auto plot = make_plot(kStressPathWidth, kStressPathHeight);
  style_axes(*plot->axisRect(), "mean effective stress p′ (kPa)", "deviator stress q (kPa)");
  plot->xAxis->setRange(p_range.with_margin(0.06, true));
  plot->yAxis->setRange(q_range.with_margin(0.10, true));

  if (path.limit_stress_ratio) draw_mohr_coulomb_line(*plot, *path.limit_stress_ratio);
  if (path.onset) draw_instability_line(*plot, path.onset->eta());
  draw_path(*plot, before, "before shear", line(kGrey, 1.2));
  draw_path(*plot, shear, before.empty() ? "stress path" : "stress path in shear",
            line(kBlue, 1.8));
  std::vector<PointLabel> labels;
  if (path.onset) {
    const QPointF at = place(*path.onset);
    mark(*plot, at, QCPScatterStyle::ssCircle, kVermilion, "onset of collapse");
    labels.push_back({at.x(), at.y(), fmt::format("η = {:.2f}", path.onset->eta()), kVermilion});
  }
  if (path.failure)
    mark(*plot, place(*path.failure), QCPScatterStyle::ssSquare, kGrey,
         "failure on the limit surface");
  if (path.true_onset)
    mark(*plot, place(*path.true_onset), QCPScatterStyle::ssCross, kInk, "true onset (model)");
  legend_below(*plot, 2);
  note_below(*plot, origin_note(path.origin));
  place_labels(*plot, labels);
  auto caption =
      path.onset ? fmt::format("Effective stress path of test {}; collapse sets in at η = {:.2f}.",
                               path.test, path.onset->eta())
                 : fmt::format("Effective stress path of test {}; no collapse point.", path.test);
  return {std::move(plot), std::move(caption)};
}

}  // namespace triax::src
