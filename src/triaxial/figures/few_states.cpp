// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/few_states.hpp"

#include <QPointF>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "src/plot/plot_style.hpp"
#include "src/plot/polyline.hpp"
#include "src/study/triaxial/shear_series.hpp"

namespace triax::src {
namespace {

using Value = double (*)(const lab::State&);

double axial_strain(const lab::State& s) { return s.strain.axial; }
double p_eff(const lab::State& s) { return s.p_eff; }
double deviator_stress(const lab::State& s) { return s.q; }

constexpr std::array<std::pair<Value, Value>, 6> kPlanes = {{
    {axial_strain, deviator_stress},
    {axial_strain, [](const lab::State& s) { return s.pore_pressure; }},
    {axial_strain, [](const lab::State& s) { return s.volumetric_strain; }},
    {axial_strain, [](const lab::State& s) { return s.p_eff > 5e3 ? s.eta() : lab::kMissing; }},
    {p_eff, deviator_stress},
    {p_eff, [](const lab::State& s) { return s.void_ratio; }},
}};

double extent(const std::vector<lab::State>& states, Value value) {
  RangeOf range;
  for (const auto& state : states) range.add(value(state));
  return range.empty() || !(range.width() > 0) ? 1 : range.width();
}

void mark_needed(const std::vector<lab::State>& states, Value x, Value y, double part,
                 std::vector<bool>& needed) {
  const double across = extent(states, x), up = extent(states, y);
  std::vector<QPointF> points;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const QPointF point(x(states[i]) / across, y(states[i]) / up);
    if (!std::isfinite(point.x()) || !std::isfinite(point.y())) continue;
    points.push_back(point);
    numbers.push_back(i);
  }
  for (const auto i : points_to_draw(points, part)) needed[numbers[i]] = true;
}

}  // namespace

void keep_few_states(study::TestResult& test, double part) {
  auto& states = test.curves.states;
  std::vector<lab::State> shear;  // what stands before it is compared nowhere
  for (const auto& state : states)
    if (study::is_shear(test.stored.header, state.stage)) shear.push_back(state);
  std::vector<bool> needed(shear.size(), false);
  for (const auto& [x, y] : kPlanes) mark_needed(shear, x, y, part, needed);
  const study::LineBreaks& breaks = test.curves.breaks;
  for (std::size_t i = 0; i + 1 < shear.size(); ++i) {
    const std::int64_t here = shear[i].reading, next = shear[i + 1].reading;
    if (breaks.is_unread(here, next) || breaks.is_faulty(here) != breaks.is_faulty(next))
      needed[i] = needed[i + 1] = true;
  }
  for (const auto& instant :
       {study::collapse_onset(test.stored), test.stored.summary.collapse.loss_of_control})
    if (const auto at = study::nearest_state(shear, instant))
      needed[static_cast<std::size_t>(std::ranges::find(shear, at->reading, &lab::State::reading) -
                                      shear.begin())] = true;
  std::vector<lab::State> kept;
  for (std::size_t i = 0; i < shear.size(); ++i)
    if (needed[i]) kept.push_back(shear[i]);
  kept.shrink_to_fit();
  test.curves.states = std::move(kept);
  test.curves.work.clear();
  test.curves.forecasts.clear();
}

}  // namespace triax::src
