#include "src/triaxial/figures/shear_curves_figure.hpp"

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
/// The close view ends at so many times the largest strain at onset.
constexpr double kOnsets = 3;

double strain_pct(const lab::State& state) { return state.strain.axial * 100; }
double q_kPa(const lab::State& state) { return state.q * 1e-3; }

/// Largest axial strain at an onset, %; 0 where there is none.
double largest_at_onset(const std::vector<study::TestResult>& tests) {
  double largest = 0;
  for (const auto& test : tests)
    if (const auto onset = study::collapse_onset(test.stored); onset && onset->axial_strain)
      largest = std::max(largest, *onset->axial_strain * 100);
  return largest;
}

Points onsets_of(const std::vector<study::TestResult>& tests) {
  Points onsets;
  for (const auto& test : tests)
    if (const auto onset = study::collapse_onset(test.stored); onset && onset->axial_strain && onset->q_pa)
      onsets.emplace_back(*onset->axial_strain * 100, *onset->q_pa * 1e-3);
  return onsets;
}

void fill(QCPAxisRect& rect, const std::vector<study::TestResult>& tests, double strain_most) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < tests.size(); ++i)
    draw_series(rect, shear_points_within(tests[i], strain_pct, q_kPa, strain_most, kAny), i);
  draw_markers(rect, onsets_of(tests), onset_marker());
}

}  // namespace

Drawing shear_curves_figure(const std::vector<study::TestResult>& tests) {
  RangeOf strain, q;
  strain.add(0);
  q.add(0);
  bool any = false;
  for (const auto& test : tests)
    for (const auto& point : shear_points(test, strain_pct, q_kPa)) {
      strain.add(point.x());
      q.add(point.y());
      any = true;
    }
  if (!any) return {};
  const auto whole = from_zero(strain.with_margin(0.04, true));
  const double close = std::min(kOnsets * largest_at_onset(tests), whole.upper);

  auto plot = make_plot(kWidth, kHeight);
  auto& left = *plot->axisRect();
  auto* right = close > 0 ? &add_axes_beside(*plot) : nullptr;
  style_axes(left, "axial strain ε₁ (%)", "deviator stress q (kPa)");
  if (right != nullptr) style_axes(*right, "axial strain ε₁ (%), detail", "q (kPa)");
  name_series(left, tests);
  legend_below(*plot, 5);
  note_below(*plot, origin_of(pointers_to(tests)));
  left.axis(QCPAxis::atBottom)->setRange(whole);
  left.axis(QCPAxis::atLeft)->setRange(from_zero(q.with_margin(0.08, true)));
  if (right != nullptr) {
    right->axis(QCPAxis::atBottom)->setRange(0, close);
    right->axis(QCPAxis::atLeft)->setRange(from_zero(q.with_margin(0.08, true)));
  }
  plot->replot();
  fill(left, tests, whole.upper);
  if (right != nullptr) fill(*right, tests, close);
  return {std::move(plot),
          fmt::format("Deviator stress over axial strain in shear of {}.", names_of(tests))};
}

}  // namespace triax::src
