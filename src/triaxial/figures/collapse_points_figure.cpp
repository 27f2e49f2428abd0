#include "src/triaxial/figures/collapse_points_figure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "src/plot/plot_style.hpp"
#include "src/plot/point_labels.hpp"
#include "src/plot/shapes.hpp"
#include "src/plot/stress_lines.hpp"
#include "src/triaxial/figures/origin_note.hpp"
#include "src/triaxial/figures/programme_looks.hpp"

namespace triax::src {
namespace {

constexpr int kWidth = 720;
constexpr int kHeight = 520 + kNoteHeight;

struct CollapsePoint {
  double p_kPa, q_kPa;
  std::string test, programme;
  bool simulated;
};

std::vector<CollapsePoint> collapse_points(const std::vector<study::TestResult>& tests) {
  std::vector<CollapsePoint> points;
  for (const auto& [test, curves] : tests) {
    const auto onset = study::collapse_onset(test);
    if (!onset || !onset->eta()) continue;
    points.push_back({*onset->p_eff_pa * 1e-3, *onset->q_pa * 1e-3, test.header.name,
                      test.header.programme.empty() ? "other" : test.header.programme,
                      test.header.origin == lab::Origin::simulated});
  }
  return points;
}

std::vector<const study::TestResult*> with_points(const std::vector<study::TestResult>& tests) {
  std::vector<const study::TestResult*> kept;
  for (const auto& test : tests)
    if (const auto onset = study::collapse_onset(test.stored); onset && onset->eta())
      kept.push_back(&test);
  return kept;
}

std::optional<double> slope(const std::vector<CollapsePoint>& points) {
  double qp = 0, pp = 0;
  for (const auto& point : points) {
    qp += point.q_kPa * point.p_kPa;
    pp += point.p_kPa * point.p_kPa;
  }
  return pp > 0 ? std::optional(qp / pp) : std::nullopt;
}

void draw_points(QCustomPlot& plot, const std::vector<CollapsePoint>& points,
                 const std::string& origin) {
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
    group->addData(point.p_kPa, point.q_kPa);
    labels.push_back({point.p_kPa, point.q_kPa, point.test, kInk});
  }
  legend_below(plot, 2);
  note_below(plot, origin);
  place_labels(plot, labels);
}

}  // namespace

std::vector<double> limits_of(const std::vector<study::TestResult>& tests) {
  std::map<std::int64_t, double> by_rounded;
  for (const auto& test : tests)
    if (const auto& m = test.stored.summary.collapse.limit_stress_ratio;
        m && std::isfinite(*m) && study::collapse_onset(test.stored))
      by_rounded.emplace(std::llround(*m * 100), *m);
  std::vector<double> values;
  values.reserve(by_rounded.size());
  for (const auto& [rounded, m] : by_rounded) values.push_back(m);
  return values;
}

std::optional<double> fitted_instability_line(const std::vector<study::TestResult>& tests) {
  return slope(collapse_points(tests));
}

Drawing collapse_points_figure(const std::vector<study::TestResult>& tests) {
  const auto points = collapse_points(tests);
  const auto eta = slope(points);
  if (!eta) return {};
  RangeOf p_range, q_range;
  p_range.add(0);
  q_range.add(0);
  for (const auto& point : points) {
    p_range.add(point.p_kPa);
    q_range.add(point.q_kPa);
  }
  auto plot = make_plot(kWidth, kHeight);
  style_axes(*plot->axisRect(), "mean effective stress p′ (kPa)", "deviator stress q (kPa)");
  plot->xAxis->setRange(p_range.with_margin(0.12, true));
  plot->yAxis->setRange(q_range.with_margin(0.35, true));
  draw_mohr_coulomb_lines(*plot, limits_of(tests));
  draw_instability_line(*plot, *eta);
  draw_points(*plot, points, origin_of(with_points(tests)));
  return {
      std::move(plot),
      fmt::format("Collapse points of {} test{} and the one instability line that fits them best "
                  "(η = {:.2f}).",
                  points.size(), points.size() == 1 ? "" : "s", *eta)};
}

}  // namespace triax::src
