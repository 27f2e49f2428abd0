#include "src/triaxial/figures/strains_over_p_figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/plot/axes.hpp"
#include "src/plot/plot_style.hpp"
#include "src/triaxial/figures/origin_note.hpp"
#include "src/triaxial/figures/series_plot.hpp"
#include "src/triaxial/figures/shear_states.hpp"

namespace triax::src {
namespace {

constexpr int kWidth = 960, kHeight = 420 + kNoteHeight;
/// Shown up to so many times the largest axial strain at onset: then the run-away is a short piece.
constexpr double kOnsets = 2.5;

double p_kPa(const lab::State& state) { return state.p_eff * 1e-3; }
double axial_pct(const lab::State& state) { return state.strain.axial * 100; }
double volumetric_pct(const lab::State& state) { return state.volumetric_strain * 100; }

double most_strain(const std::vector<study::TestResult>& tests) {
  double at_onset = 0, largest = 0;
  for (const auto& test : tests) {
    if (const auto onset = study::collapse_onset(test.stored); onset && onset->axial_strain)
      at_onset = std::max(at_onset, *onset->axial_strain * 100);
    for (const auto& state : test.curves.states)
      if (std::isfinite(state.strain.axial)) largest = std::max(largest, axial_pct(state));
  }
  return at_onset > 0 ? std::min(kOnsets * at_onset, largest) : largest;
}

/// Shear of a test up to that axial strain.
study::TestResult beginning_of(const study::TestResult& test, double most_pct) {
  study::TestResult part{test.stored, {}};
  for (const auto& state : test.curves.states) {
    if (!is_shear(test.stored.header, state.stage)) continue;
    if (axial_pct(state) > most_pct) break;
    part.curves.states.push_back(state);
  }
  return part;
}

void fill(QCPAxisRect& rect, const std::vector<study::TestResult>& tests, StateValue value) {
  Points onsets;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    draw_series(rect, shear_points(tests[i], p_kPa, value), i);
    if (const auto state = state_at_onset(tests[i]); state && std::isfinite(value(*state)))
      onsets.emplace_back(p_kPa(*state), value(*state));
  }
  draw_markers(rect, onsets, onset_marker());
}

}  // namespace

Drawing strains_over_p_figure(const std::vector<study::TestResult>& tests) {
  const double most = most_strain(tests);
  std::vector<study::TestResult> parts;
  for (const auto& test : tests) parts.push_back(beginning_of(test, most));
  RangeOf p, axial, volumetric;
  p.add(0);
  axial.add(0);
  bool any = false;
  for (const auto& part : parts)
    for (const auto& state : part.curves.states) {
      p.add(p_kPa(state));
      axial.add(axial_pct(state));
      volumetric.add(volumetric_pct(state));
      any = any || std::isfinite(p_kPa(state));
    }
  if (!any) return {};

  auto plot = make_plot(kWidth, kHeight);
  auto& left = *plot->axisRect();
  auto& right = add_axes_beside(*plot);
  style_axes(left, "mean effective stress p′ (kPa)", "axial strain ε₁ (%)");
  style_axes(right, "mean effective stress p′ (kPa)", "volumetric strain ε_v (%)");
  name_series(left, tests);
  legend_below(*plot, 5);
  note_below(*plot, origin_of(pointers_to(tests)));
  for (auto* rect : {&left, &right})
    rect->axis(QCPAxis::atBottom)->setRange(from_zero(p.with_margin(0.06, true)));
  left.axis(QCPAxis::atLeft)->setRange(from_zero(axial.with_margin(0.06, true)));
  right.axis(QCPAxis::atLeft)->setRange(volumetric.with_margin(0.08, false));
  plot->replot();
  fill(left, parts, axial_pct);
  fill(right, parts, volumetric_pct);
  return {std::move(plot),
          fmt::format("Axial and volumetric strain over p′ in shear of {}, up to ε₁ = {:.1f} %.",
                      names_of(tests), most)};
}

}  // namespace triax::src
