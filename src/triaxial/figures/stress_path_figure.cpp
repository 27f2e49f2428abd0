// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/stress_path_figure.hpp"

#include <fmt/format.h>

#include "src/plot/plot_style.hpp"
#include "src/plot/point_labels.hpp"
#include "src/plot/shapes.hpp"
#include "src/plot/stress_lines.hpp"
#include "src/triaxial/figures/joined_line.hpp"
#include "src/triaxial/figures/origin_note.hpp"

namespace triax::src {
namespace {

constexpr int kStressPathWidth = 620;
constexpr int kStressPathHeight = 460 + kNoteHeight;

QPointF place(const study::StressPoint& point) { return {point.p_pa * 1e-3, point.q_pa * 1e-3}; }

JoinedLine line_through(const std::vector<lab::State>& states, const study::LineBreaks& breaks) {
  return joined_line(states, breaks, [](const lab::State& state) {
    return place(study::StressPoint{state.p_eff, state.q});
  });
}

// The axes' ranges must be final.
void draw_path(QCustomPlot& plot, const JoinedLine& path, const std::string& name,
               const QPen& pen) {
  const double across = kStressPathWidth / plot.xAxis->range().size();
  const double up = kStressPathHeight / plot.yAxis->range().size();
  draw_joined(
      *plot.axisRect(), path, pen,
      [&](const QPointF& point) { return QPointF(point.x() * across, point.y() * up); }, name);
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
  const JoinedLine before = line_through(path.before, path.breaks);
  const JoinedLine shear = line_through(path.shear, path.breaks);
  if (before.points.empty() && shear.points.empty()) return {};
  RangeOf p_range, q_range;
  p_range.add(0);
  q_range.add(0);
  for (const auto* line : {&before, &shear})
    for (const QPointF& point : line->points) {
      p_range.add(point.x());
      q_range.add(point.y());
    }

  auto plot = make_plot(kStressPathWidth, kStressPathHeight);
  style_axes(*plot->axisRect(), "mean effective stress p′ (kPa)", "deviator stress q (kPa)");
  plot->xAxis->setRange(p_range.with_margin(0.06, true));
  plot->yAxis->setRange(q_range.with_margin(0.10, true));

  if (path.limit_stress_ratio)
    draw_mohr_coulomb_line(*plot, *path.limit_stress_ratio,
                           path.limit_intercept_pa.value_or(0) / 1e3);
  if (path.onset) draw_instability_line(*plot, path.onset->eta());
  draw_path(*plot, before, "before shear", line(kGrey, 1.2));
  draw_path(*plot, shear, before.points.empty() ? "stress path" : "stress path in shear",
            line(kBlue, 1.8));
  std::vector<PointLabel> labels;
  if (path.onset) {
    const QPointF at = place(*path.onset);
    mark(*plot, at, QCPScatterStyle::ssCircle, kVermilion, "onset of instability");
    labels.push_back({at.x(), at.y(), fmt::format("η = {:.2f}", path.onset->eta()), kVermilion});
  }
  if (path.loss_of_control)
    mark(*plot, place(*path.loss_of_control), QCPScatterStyle::ssDiamond, kPurple,
         "loss of control");
  if (path.failure)
    mark(*plot, place(*path.failure), QCPScatterStyle::ssSquare, kGrey, "failure, not collapse");
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
