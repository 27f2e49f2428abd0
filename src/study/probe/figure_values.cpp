// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/figure_values.hpp"

#include <algorithm>
#include <cmath>

namespace triax::study {
namespace {

/// Curves that one diagram can hold and still be read.
constexpr std::size_t kMostCurves = 5;

/// Places of the states whose circles are drawn.
std::vector<std::size_t> drawn_states(const ProbeResult& result) {
  std::vector<std::size_t> answered, drawn;
  for (std::size_t i = 0; i < result.states.size(); ++i)
    if (result.states[i].circle.least.answered) answered.push_back(i);
  const std::size_t count = answered.size(), shown = std::min(count, kMostCurves);
  for (std::size_t i = 0; i < shown; ++i)
    drawn.push_back(answered[shown == 1 ? 0 : i * (count - 1) / (shown - 1)]);
  return drawn;
}

/// Finer than the probes of the result, if those would look angular.
Probing drawn_probing(const Probing& probing) {
  constexpr double kCoarse = 2;  // degrees
  constexpr int kDirections = 360;
  Probing fine = probing;
  if (probing.step_deg() > kCoarse) fine.directions = kDirections;
  return fine;
}

/// Whether two states would be drawn over each other: within 1/40 of the largest stress.
bool close_together(const TriaxialState& a, const TriaxialState& b, double largest) {
  return std::hypot(a.p - b.p, a.q - b.q) < largest / 40;
}

ConesPicture cones_of(const ProbeResult& result) {
  ConesPicture picture;
  if (const auto* law = result.material.material.axisymmetric.get())
    picture.limit_stress_ratio = law->limit_stress_ratio();
  double largest = 0;
  for (const ProbedState& state : result.states)
    largest = std::max({largest, state.p, std::abs(state.q)});
  std::vector<TriaxialState> path;
  for (const ProbedState& state : result.states) {
    const TriaxialState at{state.p, state.q};
    if (picture.states.empty() || !close_together(at, picture.states.back().state, largest))
      picture.states.push_back({at, sectors_of(state.circle)});
    if (state.from_path) path.push_back(at);
    if (state.own)
      picture.tests.push_back(
          {state.test->name, at, state.own->angle, state.test->origin == lab::Origin::simulated});
  }
  if (path.size() > 1) picture.paths.push_back(std::move(path));
  return picture;
}

}  // namespace

template <class Space>
ProbeFigureValues figure_values(const ProbeResult& result,
                                const std::vector<StateToProbe<Space>>& probed) {
  const Probing fine = drawn_probing(result.probing);
  ProbeFigureValues values{.directions = fine.directions, .circles = {}, .cones = {}};
  for (const std::size_t i : drawn_states(result)) {
    const bool finer = fine.directions != result.probing.directions;
    sim::Circle circle =
        finer ? probed_circle(result.material, probed[i], fine) : result.states[i].circle;
    if (circle.least.answered) values.circles.push_back({i, std::move(circle)});
  }
  if (result.probing.plane == sim::ProbePlane::axisymmetric &&
      result.probing.kind == sim::ProbeKind::stress)
    values.cones = cones_of(result);
  return values;
}

template ProbeFigureValues figure_values(const ProbeResult&,
                                         const std::vector<StateToProbe<sim::Axisymmetric>>&);
template ProbeFigureValues figure_values(const ProbeResult&,
                                         const std::vector<StateToProbe<sim::Tensor>>&);

}  // namespace triax::study
