// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/output/simulated_head.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"
#include "src/plot/subject.hpp"
#include "src/probe/control_text.hpp"
#include "src/probe/probe_words.hpp"

namespace triax::src {
namespace {

std::string openings(const std::vector<sim::Cone>& cones) {
  std::string words;
  for (const auto& cone : cones)
    words += (words.empty() ? "" : ", ") + in_degrees(cone.opening(), 2);
  return words.empty() ? kUnknown : words;
}

std::string normalised_words(const sim::Probe& probe) {
  return number(probe.answered ? std::optional(probe.normalised) : std::nullopt, 4);
}

Table state_table(const study::ProbeResult& result) {
  const bool named =
      std::ranges::any_of(result.states, [](const auto& s) { return !s.name.empty(); });
  Table table;
  if (named) table.columns.push_back({"state", Align::left});
  const std::string unloading =
      fmt::format("W₂ at {}°", in_degrees(isotropic_unloading(result.probing.plane), 2));
  for (const std::string& heading :
       {std::string("p′ (kPa)"), std::string("q (kPa)"), std::string("η"), std::string("e"),
        std::string("cones (°)"), std::string("opening (°)"), std::string("least W₂"),
        std::string("at α (°)"), unloading})
    table.columns.push_back({heading, Align::right});
  for (const study::ProbedState& state : result.states) {
    std::vector<std::string> row;
    if (named) row.push_back(state.name);
    const sim::Probe& least = state.circle.least;
    row.insert(row.end(), {in_kPa(state.p, 2), in_kPa(state.q, 2), number(state.eta(), 4),
                           number(state.void_ratio, 4),
                           cones_in_words(state.circle, result.probing.directions),
                           openings(state.circle.cones), normalised_words(least),
                           in_degrees(least.answered ? std::optional(least.angle) : std::nullopt),
                           normalised_words(state.isotropic_unloading)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table probes_table(const study::ProbeResult& result, const study::ProbedState& state) {
  const double root = result.probing.axisymmetric() ? std::numbers::sqrt2 : 1;
  Table table;
  for (const char* heading :
       {"α (°)", "W₂ norm.", "W₂ (Pa)", "dσ₁ (kPa)", "dσ₃ (kPa)", "dε₁", "dε₃"})
    table.columns.push_back({heading, Align::right});
  for (const sim::Probe& probe : state.circle.probes) {
    std::vector<std::string> row = {in_degrees(probe.angle, 2)};
    if (probe.answered)
      row.insert(row.end(),
                 {number(probe.normalised, 5), fmt::format("{:.4g}", probe.second_order_work),
                  in_kPa(probe.stress.y(), 4), in_kPa(probe.stress.x() / root, 4),
                  fmt::format("{:.4e}", probe.strain.y()),
                  fmt::format("{:.4e}", probe.strain.x() / root)});
    else
      row.insert(row.end(), 6, kUnknown);
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Where the test's own increment lies.
std::string own_words(const study::ProbedState& state) {
  const lab::MeasuredIncrement& own = *state.test->increment;
  std::string words = fmt::format("α {}° ± {}°, measured W₂ {} ± {}", in_degrees(own.angle, 1),
                                  in_degrees(own.angle_error, 1), number(own.normalised, 3),
                                  number(own.normalised_error, 3));
  if (state.own) words += ", the law's W₂ there " + normalised_words(*state.own);
  return words;
}

std::string place_words(const study::ProbedState& state, int directions) {
  const lab::MeasuredIncrement& own = *state.test->increment;
  const auto& place = state.own_place;
  if (!place) return "cones of the law at this state: " + cones_in_words(state.circle, directions);
  const std::string cone = cones_in_words({state.circle.cones[place->cone]});
  if (!place->certain(own.angle_error))
    return fmt::format("on the edge of the cone {} within its error, {}° {}", cone,
                       in_degrees(place->to_edge, 1), place->inside ? "inside" : "outside");
  return fmt::format("{} the cone {}, {}° from the nearest edge",
                     place->inside ? "inside" : "outside", cone, in_degrees(place->to_edge, 1));
}

std::string closed_form_words(const std::vector<sim::UnstableSector>& sectors) {
  std::string words;
  for (const auto& sector : sectors)
    words += fmt::format("{}{}–{}", words.empty() ? "" : ", ", in_degrees(sector.from, 2),
                         in_degrees(sector.to, 2));
  return words.empty() ? "none" : words;
}

std::string first_words(const study::ProbeResult& result) {
  const auto first = result.first_unstable();
  const bool on_path = !result.path.empty();
  if (!first)
    return fmt::format("no unstable direction at any of these {}", on_path ? "rows" : "states");
  return fmt::format("unstable state {}: p′ {} kPa, q {} kPa, η {}, e {}{}, α {}°",
                     on_path ? "of the path" : "(smallest |η|)", in_kPa(first->p, 2),
                     in_kPa(first->q, 2), number(first->eta(), 4), number(first->void_ratio, 4),
                     first->axial_strain ? ", ε₁ " + in_percent(first->axial_strain, 4) + " %" : "",
                     in_degrees(first->angle));
}

std::string test_words(const study::TestedState& test) {
  const lab::State& s = test.state;
  std::string words = fmt::format(
      "{} (number {}, {}) at {}reading {}", test.name, test.id, lab::to_string(test.origin),
      std::isdigit(static_cast<unsigned char>(test.at.front())) != 0 ? "" : test.at + ", ",
      s.reading);
  if (test.has_time && std::isfinite(s.time_s)) words += ", " + duration(s.time_s);
  if (std::isfinite(s.strain.axial)) words += ", ε₁ " + in_percent(s.strain.axial, 3) + " %";
  return words;
}

std::string state_words(const study::ProbedState& state) {
  return fmt::format("{}p′ {} kPa, q {} kPa, η {}",
                     state.name.empty() ? "" : on_one_line(state.name) + ": ", in_kPa(state.p, 2),
                     in_kPa(state.q, 2), number(state.eta(), 4));
}

std::string state_heading(const study::ProbedState& state) {
  return "  " + state_words(state) + '\n';
}

std::string control_text(const study::Controllability& control) {
  std::string out = indented(to_text(scan_table(control)));
  if (!control.named.empty()) out += '\n' + indented(to_text(named_controls_table(control)));
  return out;
}

}  // namespace

std::string probe_text(const study::ProbeResult& result, const ProbeDetails& details) {
  std::string out = simulated_head("Second-order work in every direction", result.material);
  out += fact("probes", probing_words(result.probing));
  out += fact("plane", plane_words(result.probing.plane));
  out += fact("path", result.path);
  for (const study::ProbedState& state : result.states)
    if (state.test) {
      out += fact("test", test_words(*state.test));
      out += fact("state", "σ′ and e as measured; the law has no memory of a reversal of shear");
    }
  out += '\n' + indented(to_text(state_table(result)));
  out += fmt::format(
      "  W₂ normalised, dσ′:dε/(|dσ′||dε|){}; the last column is that of isotropic "
      "unloading{}\n\n",
      result.probing.axisymmetric() ? "" : ", norms in the plane",
      result.probing.kind == sim::ProbeKind::strain ? ", a stress increment by the rate" : "");
  for (const study::ProbedState& state : result.states) {
    if (state.circle.unanswered > 0)
      out += fact("no answer", (state.name.empty() ? "" : state.name + ": ") +
                                   unanswered_words(state, result.probing.directions));
    if (state.closed_form)
      out += fact("closed form", (state.name.empty() ? "" : state.name + ": ") + "cones " +
                                     closed_form_words(*state.closed_form));
    if (!state.test || !state.test->increment) continue;
    out += fact("increment", own_words(state));
    if (state.own && result.probing.kind == sim::ProbeKind::stress)
      out += fact("", place_words(state, result.probing.directions));
  }
  if (result.states.size() == 1) {
    const study::ProbedState& state = result.states.front();
    const std::string by = result.probing.finite ? "by the rate, " : "";
    out += fact("control", fmt::format("{}of dε₁ + {}R dε₃ and dσ₁′ − dσ₃′/R: {}", by,
                                       result.probing.axisymmetric() ? "2" : "",
                                       lost_in_words(state.control)));
    out += fact(result.probing.axisymmetric() ? "Eq. (34)" : "Eq. (35)",
                by + roots_in_words(state.control));
  }
  for (const study::ProbedState& state : result.states)
    for (const auto& at : state.control.conditions)
      out += fact("conditions", (result.states.size() > 1 ? state_words(state) + ": " : "") +
                                    condition_words(at));
  if (result.has_first()) out += fact("first", first_words(result));
  std::vector<const study::StateHead*> heads;
  for (const study::ProbedState& state : result.states) heads.push_back(&state);
  for (const auto& warning : result.warnings) out += fact("warning", warning);
  for (const auto& warning : study::warnings_of(heads))
    if (std::ranges::find(result.warnings, warning) == result.warnings.end())
      out += fact("warning", warning);
  for (const study::ProbedState& state : result.states) {
    if ((details.probes || details.control) && result.states.size() > 1)
      out += '\n' + state_heading(state);
    if (details.control) out += '\n' + control_text(state.control);
    if (details.probes) out += '\n' + indented(to_text(probes_table(result, state)));
  }
  return without_controls(out);
}

}  // namespace triax::src
