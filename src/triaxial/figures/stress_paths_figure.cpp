// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/stress_paths_figure.hpp"

#include <fmt/format.h>

#include "src/plot/plot_style.hpp"
#include "src/plot/stress_lines.hpp"
#include "src/study/triaxial/stress_path.hpp"
#include "src/triaxial/figures/origin_note.hpp"
#include "src/triaxial/figures/series_plot.hpp"

namespace triax::src {
namespace {

constexpr int kStressPathsWidth = 720, kStressPathsHeight = 480 + kNoteHeight;

Points stresses_of(const study::ShearSeries& series,
                   std::optional<lab::Instant> study::SeriesTest::*instant) {
  Points places;
  for (const auto& test : series.tests)
    if (const auto at = study::stress_at(test.*instant))
      places.emplace_back(at->p_pa * 1e-3, at->q_pa * 1e-3);
  return places;
}

}  // namespace

Drawing stress_paths_figure(const study::ShearSeries& series) {
  std::vector<JoinedLine> paths;
  RangeOf p_range, q_range;
  p_range.add(0);
  q_range.add(0);
  bool any = false;
  for (const auto& test : series.tests) {
    paths.push_back(line_of(test, p_kPa, q_kPa));
    for (const auto& point : paths.back().points) {
      p_range.add(point.x());
      q_range.add(point.y());
      any = true;
    }
  }
  if (!any) return {};

  auto plot = make_plot(kStressPathsWidth, kStressPathsHeight);
  auto& rect = *plot->axisRect();
  style_axes(rect, "mean effective stress p′ (kPa)", "deviator stress q (kPa)");
  plot->xAxis->setRange(from_zero(p_range.with_margin(0.06, true)));
  plot->yAxis->setRange(from_zero(q_range.with_margin(0.10, true)));
  draw_mohr_coulomb_lines(*plot, series.limit_stress_ratios);
  const auto& lines = series.instability_lines;
  for (const double eta : lines) draw_instability_line(*plot, eta);
  name_series(rect, series.tests);
  legend_below(*plot, 3);
  note_below(*plot, origin_note(series.origin));
  plot->replot();  // the layout gives pixels their meaning
  for (std::size_t i = 0; i < paths.size(); ++i) draw_series(rect, paths[i], i, paths.size());
  draw_markers(rect, stresses_of(series, &study::SeriesTest::onset), onset_marker());
  draw_markers(rect, stresses_of(series, &study::SeriesTest::loss_of_control),
               loss_of_control_marker());
  return {std::move(plot),
          fmt::format("Effective stress paths in shear of {}{}.", names_of(series.tests),
                      lines.empty() ? std::string("; no collapse point")
                                    : fmt::format(", with the instability line through their "
                                                  "collapse points ({})",
                                                  instability_words(lines)))};
}

}  // namespace triax::src
