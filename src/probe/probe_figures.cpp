// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/output/words.hpp"
#include "src/probe/figures/circular_diagram.hpp"
#include "src/probe/figures/cones_figure.hpp"
#include "src/probe/figures/control_scan_figure.hpp"
#include "src/probe/figures/response_envelope.hpp"
#include "src/probe/figures/work_over_angle.hpp"
#include "src/probe/probe_data.hpp"

namespace triax::src {
namespace {

bool all_share(const std::vector<const study::ProbedState*>& states,
               double study::StateHead::*value) {
  return std::ranges::all_of(states, [&](const study::ProbedState* s) {
    return std::abs(s->*value - states.front()->*value) <= 1e-9 * std::abs(s->*value);
  });
}

std::string eta_words(const study::ProbedState& state) { return "η = " + number(state.eta(), 3); }

/// What tells a state from the others.
std::string curve_name(const study::ProbedState& state, bool one_p) {
  if (!state.name.empty()) return state.name + ", " + eta_words(state);
  return one_p ? eta_words(state)
               : fmt::format("{}, p′ = {} kPa", eta_words(state), number(state.p / 1e3, 1));
}

Subject subject_of(const study::ProbeResult& result,
                   const std::vector<const study::ProbedState*>& states) {
  Subject subject{.material = result.material.name,
                  .state = {},
                  .plane = result.probing.plane,
                  .kind = result.probing.kind};
  if (states.empty()) return subject;
  if (all_share(states, &study::StateHead::p))
    subject.state = fmt::format("p′ = {:.4g} kPa", states.front()->p / 1e3);
  if (all_share(states, &study::StateHead::void_ratio))
    subject.state +=
        fmt::format("{}e = {:.4g}", subject.state.empty() ? "" : ", ", states.front()->void_ratio);
  if (states.size() == 1) subject.state += ", " + eta_words(*states.front());
  return subject;
}

std::vector<const study::ProbedState*> drawn_states(const study::ProbeResult& result) {
  std::vector<const study::ProbedState*> drawn;
  for (const auto& one : result.figures.circles) drawn.push_back(&result.states[one.state]);
  return drawn;
}

std::vector<const study::ProbedState*> all_states(const study::ProbeResult& result) {
  std::vector<const study::ProbedState*> all;
  for (const study::ProbedState& state : result.states) all.push_back(&state);
  return all;
}

std::vector<NamedScan> scans_of(const std::vector<const study::ProbedState*>& states, bool one_p) {
  std::vector<NamedScan> scans;
  for (const study::ProbedState* state : states)
    scans.push_back({curve_name(*state, one_p), state->control.scan,
                     study::lost_of_either_sense(state->control)});
  return scans;
}

}  // namespace

std::vector<NamedFigure> probe_figures(const study::ProbeResult& result) {
  const auto& drawn = result.figures.circles;
  if (drawn.empty()) return {};
  const auto states = drawn_states(result);
  const Subject subject = subject_of(result, states);
  const bool one_p = all_share(states, &study::StateHead::p);
  std::vector<NamedCircle> circles;
  for (const auto& one : drawn)
    circles.push_back({curve_name(result.states[one.state], one_p), one.circle});
  std::vector<NamedFigure> figures;
  const auto add = [&](const char* name, Drawing drawing, const FigureData& data) {
    if (drawing.plot) figures.push_back({name, std::move(drawing), data});
  };
  const FigureData probes = drawn_probes_data(result, drawn);
  add("circular", circular_diagram(circles, subject), probes);
  add("polar", polar_diagram(circles, subject), probes);
  add("work", work_over_angle(circles, subject), probes);
  add("envelope",
      response_envelope(drawn.back().circle, result.probing.norm,
                        subject_of(result, {states.back()})),
      drawn_probes_data(result, {drawn.back()}));
  add("control", control_scan_figure(scans_of(states, one_p), subject), drawn_control_data(result));
  const Subject all = subject_of(result, all_states(result));
  const FigureData cones = cones_data(result);
  add("cones_pq", cones_figure(result.figures.cones, all, StressAxes::p_q), cones);
  add("cones_rendulic", cones_figure(result.figures.cones, all, StressAxes::rendulic), cones);
  return figures;
}

}  // namespace triax::src
