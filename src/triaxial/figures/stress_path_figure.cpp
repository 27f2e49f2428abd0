#include "src/triaxial/figures/stress_path_figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/plot/plot_style.hpp"
#include "src/plot/point_labels.hpp"
#include "src/plot/polyline.hpp"
#include "src/plot/stress_lines.hpp"
#include "src/triaxial/figures/origin_note.hpp"
#include "src/triaxial/figures/shear_states.hpp"

namespace triax::src {
namespace {

constexpr int kWidth = 620;
constexpr int kHeight = 460 + kNoteHeight;

using Path = std::vector<QPointF>;  // p′ and q in kPa

void add(Path& path, const lab::State& state) {
  if (std::isfinite(state.p_eff) && std::isfinite(state.q))
    path.emplace_back(state.p_eff * 1e-3, state.q * 1e-3);
}

// The axes' ranges must be final.
void draw_path(QCustomPlot& plot, const Path& path, const std::string& name, const QPen& pen) {
  if (path.empty()) return;
  auto pixels = path;
  for (auto& point : pixels)
    point = {point.x() * kWidth / plot.xAxis->range().size(),
             point.y() * kHeight / plot.yAxis->range().size()};
  auto* curve = new QCPCurve(plot.xAxis, plot.yAxis);
  for (const auto i : points_to_draw(pixels, kInvisible)) curve->addData(path[i].x(), path[i].y());
  curve->setPen(pen);
  curve->setName(QString::fromStdString(name));
}

void mark(QCustomPlot& plot, double p_pa, double q_pa, QCPScatterStyle::ScatterShape shape,
          const QColor& colour, const std::string& name) {
  auto* point = new QCPCurve(plot.xAxis, plot.yAxis);
  point->addData(p_pa * 1e-3, q_pa * 1e-3);
  point->setLineStyle(QCPCurve::lsNone);
  point->setScatterStyle(QCPScatterStyle(shape, line(colour, 1.8), QBrush(Qt::white), 10));
  point->setName(QString::fromStdString(name));
}

}  // namespace

Drawing stress_path_figure(const study::TestResult& test) {
  Path before, shear;
  RangeOf p_range, q_range;
  p_range.add(0);
  q_range.add(0);
  for (const auto& state : test.curves.states) {
    add(is_shear(test.stored.header, state.stage) ? shear : before, state);
    p_range.add(state.p_eff * 1e-3);
    q_range.add(state.q * 1e-3);
  }
  if (before.empty() && shear.empty()) return {};

  auto plot = make_plot(kWidth, kHeight);
  style_axes(*plot->axisRect(), "mean effective stress p′ (kPa)", "deviator stress q (kPa)");
  plot->xAxis->setRange(p_range.with_margin(0.06, true));
  plot->yAxis->setRange(q_range.with_margin(0.10, true));

  const auto& summary = test.stored.summary;
  const auto onset = study::collapse_onset(test.stored);
  const auto eta = onset ? onset->eta() : std::nullopt;
  if (summary.collapse.limit_stress_ratio)
    draw_mohr_coulomb_line(*plot, *summary.collapse.limit_stress_ratio);
  if (eta) draw_instability_line(*plot, *eta);
  draw_path(*plot, before, "before shear", line(kGrey, 1.2));
  draw_path(*plot, shear, before.empty() ? "stress path" : "stress path in shear",
            line(kBlue, 1.8));
  std::vector<PointLabel> labels;
  if (eta) {
    mark(*plot, *onset->p_eff_pa, *onset->q_pa, QCPScatterStyle::ssCircle, kVermilion,
         "onset of collapse");
    labels.push_back({*onset->p_eff_pa * 1e-3, *onset->q_pa * 1e-3, fmt::format("η = {:.2f}", *eta),
                      kVermilion});
  }
  if (const auto failure = study::failure_onset(test.stored); failure && failure->eta())
    mark(*plot, *failure->p_eff_pa, *failure->q_pa, QCPScatterStyle::ssSquare, kGrey,
         "failure on the limit surface");
  if (const auto& truth = summary.truth; truth && truth->p_eff_pa && truth->q_pa)
    mark(*plot, *truth->p_eff_pa, *truth->q_pa, QCPScatterStyle::ssCross, kInk,
         "true onset (model)");
  legend_below(*plot, 2);
  note_below(*plot, origin_of({&test}));
  place_labels(*plot, labels);
  auto caption =
      eta ? fmt::format("Effective stress path of test {}; collapse sets in at η = {:.2f}.",
                        test.stored.header.name, *eta)
          : fmt::format("Effective stress path of test {}; no collapse point.",
                        test.stored.header.name);
  return {std::move(plot), std::move(caption)};
}

}  // namespace triax::src
