// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/shear_curves_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/plot/axes.hpp"
#include "src/plot/plot_style.hpp"
#include "src/triaxial/figures/origin_note.hpp"
#include "src/triaxial/figures/series_plot.hpp"

namespace triax::src {
namespace {

constexpr int kShearCurvesWidth = 960, kShearCurvesHeight = 420 + kNoteHeight;
/// The close view ends at so many times the largest strain at onset.
constexpr double kOnsets = 3;
constexpr double kLargestDetail = 0.6;  // of the whole

double strain_pct(const lab::State& state) { return state.strain.axial * 100; }

Points places_of(const study::ShearSeries& series,
                 std::optional<lab::Instant> study::SeriesTest::*instant) {
  Points places;
  for (const auto& test : series.tests)
    if (const auto& at = test.*instant; at && at->axial_strain && at->q_pa)
      places.emplace_back(*at->axial_strain * 100, *at->q_pa * 1e-3);
  return places;
}

void fill(QCPAxisRect& rect, const study::ShearSeries& series, double strain_most) {
  for (std::size_t i = 0; i < series.tests.size(); ++i)
    draw_series(rect, line_of(series.tests[i], strain_pct, q_kPa, strain_most), i,
                series.tests.size());
  draw_markers(rect, places_of(series, &study::SeriesTest::onset), onset_marker());
  draw_markers(rect, places_of(series, &study::SeriesTest::loss_of_control),
               loss_of_control_marker());
}

/// The last strain in the detail, with a margin: after a run-away there may be none near its end.
double detail_end(const study::ShearSeries& series, double close) {
  double last = 0;
  for (const auto& test : series.tests)
    for (const auto& point : points_of(test.states, strain_pct, q_kPa, close))
      last = std::max(last, point.x());
  return last > 0 ? std::min(close, 1.04 * last) : close;
}

}  // namespace

Drawing shear_curves_figure(const study::ShearSeries& series) {
  RangeOf strain, q;
  strain.add(0);
  q.add(0);
  bool any = false;
  for (const auto& test : series.tests)
    for (const auto& point : points_of(test.states, strain_pct, q_kPa)) {
      strain.add(point.x());
      q.add(point.y());
      any = true;
    }
  if (!any) return {};
  const auto whole = from_zero(strain.with_margin(0.04, true));
  // A detail that shows most of the whole is none.
  double close = kOnsets * (series.strain_at_onset * 100);
  if (close > kLargestDetail * whole.upper) close = 0;

  auto plot = make_plot(kShearCurvesWidth, kShearCurvesHeight);
  auto& left = *plot->axisRect();
  auto* right = close > 0 ? &add_axes_beside(*plot) : nullptr;
  style_axes(left, "axial strain ε₁ (%)", "deviator stress q (kPa)");
  if (right != nullptr) style_axes(*right, "axial strain ε₁ (%), detail", "q (kPa)");
  name_series(left, series.tests);
  legend_below(*plot, 5);
  note_below(*plot, origin_note(series.origin));
  left.axis(QCPAxis::atBottom)->setRange(whole);
  left.axis(QCPAxis::atLeft)->setRange(from_zero(q.with_margin(0.08, true)));
  if (right != nullptr) {
    right->axis(QCPAxis::atBottom)->setRange(0, detail_end(series, close));
    right->axis(QCPAxis::atLeft)->setRange(from_zero(q.with_margin(0.08, true)));
  }
  plot->replot();
  fill(left, series, whole.upper);
  if (right != nullptr) fill(*right, series, close);
  return {std::move(plot),
          fmt::format("Deviator stress over axial strain in shear of {}.", names_of(series.tests))};
}

}  // namespace triax::src
