// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/strains_over_p_figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/plot/axes.hpp"
#include "src/plot/plot_style.hpp"
#include "src/triaxial/figures/origin_note.hpp"
#include "src/triaxial/figures/series_plot.hpp"

namespace triax::src {
namespace {

constexpr int kStrainsOverPWidth = 960, kStrainsOverPHeight = 420 + kNoteHeight;
/// A volume that is shut in is a line, not the rounding of its last digit.
constexpr double kLeastVolumetric_pct = 0.1;

double axial_pct(const lab::State& state) { return state.strain.axial * 100; }
double volumetric_pct(const lab::State& state) { return state.volumetric_strain * 100; }

void fill(QCPAxisRect& rect, const std::vector<study::SeriesTest>& tests, StateValue value) {
  Points onsets, losses;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    draw_series(rect, line_of(tests[i], p_kPa, value), i, tests.size());
    if (const auto& state = tests[i].at_onset; state && std::isfinite(value(*state)))
      onsets.emplace_back(p_kPa(*state), value(*state));
    if (const auto& state = tests[i].at_loss_of_control; state && std::isfinite(value(*state)))
      losses.emplace_back(p_kPa(*state), value(*state));
  }
  draw_markers(rect, onsets, onset_marker());
  draw_markers(rect, losses, loss_of_control_marker());
}

}  // namespace

Drawing strains_over_p_figure(const study::ShearBeginnings& beginnings) {
  const auto& [series, last_strain] = beginnings;
  RangeOf p, axial, volumetric;
  p.add(0);
  axial.add(0);
  bool any = false;
  for (const auto& test : series.tests)
    for (const auto& state : test.states) {
      p.add(p_kPa(state));
      axial.add(axial_pct(state));
      volumetric.add(volumetric_pct(state));
      any = any || std::isfinite(p_kPa(state));
    }
  if (!any) return {};

  auto plot = make_plot(kStrainsOverPWidth, kStrainsOverPHeight);
  auto& left = *plot->axisRect();
  auto& right = add_axes_beside(*plot);
  style_axes(left, "mean effective stress p′ (kPa)", "axial strain ε₁ (%)");
  style_axes(right, "mean effective stress p′ (kPa)", "volumetric strain ε_v (%)");
  name_series(left, series.tests);
  legend_below(*plot, 5);
  note_below(*plot, origin_note(series.origin));
  for (auto* rect : {&left, &right})
    rect->axis(QCPAxis::atBottom)->setRange(from_zero(p.with_margin(0.06, true)));
  left.axis(QCPAxis::atLeft)->setRange(from_zero(axial.with_margin(0.06, true)));
  volumetric.widen_to(kLeastVolumetric_pct);
  right.axis(QCPAxis::atLeft)->setRange(volumetric.with_margin(0.08, false));
  plot->replot();
  fill(left, series.tests, axial_pct);
  fill(right, series.tests, volumetric_pct);
  return {std::move(plot),
          fmt::format("Axial and volumetric strain over p′ in shear of {}, up to ε₁ = {:.1f} %.",
                      names_of(series.tests), last_strain * 100)};
}

}  // namespace triax::src
