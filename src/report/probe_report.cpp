#include "src/report/probe_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/figures/subject.hpp"
#include "src/output/table.hpp"
#include "src/report/simulated_head.hpp"
#include "src/report/words.hpp"

namespace triax::src {
namespace {

bool axisymmetric(const Probing& probing) { return probing.plane == sim::ProbePlane::axisymmetric; }

std::string openings(const std::vector<sim::Cone>& cones) {
  std::string words;
  for (const auto& cone : cones)
    words += (words.empty() ? "" : ", ") + in_degrees(cone.opening(), 2);
  return words.empty() ? kUnknown : words;
}

std::string normalised(const sim::Probe& probe) {
  return number(probe.answered ? std::optional(probe.normalised) : std::nullopt, 4);
}

Table state_table(const ProbeReport& report) {
  const bool named =
      std::ranges::any_of(report.states, [](const auto& s) { return !s.name.empty(); });
  Table table;
  if (named) table.columns.push_back({"state", Align::left});
  const std::string unloading =
      fmt::format("W₂ at {}°", in_degrees(isotropic_unloading(report.probing.plane), 2));
  for (const std::string& heading :
       {std::string("p′ (kPa)"), std::string("q (kPa)"), std::string("η"), std::string("e"),
        std::string("cones (°)"), std::string("opening (°)"), std::string("least W₂"),
        std::string("at α (°)"), unloading})
    table.columns.push_back({heading, Align::right});
  for (const ProbedState& state : report.states) {
    std::vector<std::string> row;
    if (named) row.push_back(state.name);
    const sim::Probe& least = state.circle.least;
    row.insert(row.end(), {in_kPa(state.p, 2), in_kPa(state.q, 2), number(state.eta(), 4),
                           number(state.void_ratio, 4), cones_in_words(state.circle.cones),
                           openings(state.circle.cones), normalised(least),
                           in_degrees(least.answered ? std::optional(least.angle) : std::nullopt),
                           normalised(state.isotropic_unloading)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table probes_table(const ProbeReport& report, const ProbedState& state) {
  const double root = axisymmetric(report.probing) ? std::numbers::sqrt2 : 1;
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
std::string own_words(const ProbedState& state) {
  const lab::MeasuredIncrement& own = *state.test->increment;
  std::string words = fmt::format("α {}° ± {}°, measured W₂ {} ± {}", in_degrees(own.angle, 1),
                                  in_degrees(own.angle_error, 1), number(own.normalised, 3),
                                  number(own.normalised_error, 3));
  if (state.own) words += ", the law's W₂ there " + normalised(*state.own);
  return words;
}

std::string place_words(const ProbedState& state) {
  const auto place = place_among(state.circle.cones, state.test->increment->angle);
  if (!place) return "the law has no cone at this state";
  return fmt::format("{} the cone {}, {}° {} its nearest edge",
                     place->inside ? "inside" : "outside",
                     cones_in_words({state.circle.cones[place->cone]}),
                     in_degrees(place->to_edge, 1), place->inside ? "within" : "from");
}

std::string test_words(const TestedState& test) {
  const lab::State& s = test.state;
  std::string words = fmt::format(
      "{} (number {}, {}) at {}reading {}", test.name, test.id, lab::to_string(test.origin),
      std::isdigit(static_cast<unsigned char>(test.at.front())) != 0 ? "" : test.at + ", ",
      s.reading);
  if (test.has_time && std::isfinite(s.time_s)) words += ", " + duration(s.time_s);
  if (std::isfinite(s.strain.axial)) words += ", ε₁ " + in_percent(s.strain.axial, 3) + " %";
  return words;
}

std::string state_heading(const ProbedState& state) {
  return fmt::format("  {}p′ {} kPa, q {} kPa, η {}\n",
                     state.name.empty() ? "" : on_one_line(state.name) + ": ", in_kPa(state.p, 2),
                     in_kPa(state.q, 2), number(state.eta(), 4));
}

std::string control_text(const ControlReport& control) {
  std::string out = indented(to_text(scan_table(control)));
  if (!control.named.empty()) out += '\n' + indented(to_text(named_controls_table(control)));
  return out;
}

}  // namespace

std::string plane_words(sim::ProbePlane plane) {
  return plane == sim::ProbePlane::axisymmetric
             ? "axisymmetric, α from √2 dσ₃ towards dσ₁ (Rendulic plane)"
             : "plane strain, α from dσ₃ towards dσ₁";
}

std::string probing_words(const Probing& probing) {
  const bool stress = probing.kind == sim::ProbeKind::stress;
  return fmt::format("{} of {:g}{} every {:g}°, {}", stress ? "stress" : "strain",
                     stress ? probing.norm / 1e3 : probing.norm, stress ? " kPa" : "",
                     probing.step_deg(),
                     probing.finite ? "each increment integrated" : "by the rate at the state");
}

std::string cones_in_words(const std::vector<sim::Cone>& cones) {
  std::string words;
  for (const auto& cone : cones)
    words += fmt::format("{}{}–{}", words.empty() ? "" : ", ", in_degrees(cone.from, 2),
                         in_degrees(cone.to, 2));
  return words.empty() ? "none" : words;
}

std::optional<std::size_t> ProbeReport::first_unstable() const {
  const auto found =
      std::ranges::find_if(states, [](const ProbedState& s) { return s.circle.unstable(); });
  if (found == states.end()) return std::nullopt;
  return static_cast<std::size_t>(found - states.begin());
}

std::string probe_text(const ProbeReport& report, const ProbeDetails& details) {
  std::string out = simulated_head("Second-order work in every direction", report.material);
  out += fact("probes", probing_words(report.probing));
  out += fact("plane", plane_words(report.probing.plane));
  out += fact("path", report.path);
  for (const ProbedState& state : report.states)
    if (state.test) {
      out += fact("test", test_words(*state.test));
      out += fact("state",
                  "σ′ and e as measured; the law's memory is that without a reversal of shear");
    }
  out += '\n' + indented(to_text(state_table(report)));
  out += "  W₂ normalised, dσ′:dε/(|dσ′||dε|); the last column is that of isotropic unloading\n\n";
  for (const ProbedState& state : report.states) {
    if (state.circle.unanswered > 0)
      out += fact("no answer",
                  fmt::format("{}{} of {} directions: beyond the law's limit, or refused by it",
                              state.name.empty() ? "" : state.name + ": ", state.circle.unanswered,
                              report.probing.directions));
    if (!state.test || !state.test->increment) continue;
    out += fact("own", own_words(state));
    if (state.own && report.probing.kind == sim::ProbeKind::stress)
      out += fact("", place_words(state));
  }
  if (report.states.size() == 1) {
    const ProbedState& state = report.states.front();
    out += fact("control",
                fmt::format("of dε₁ + {}R dε₃ and dσ₁′ − dσ₃′/R: {}",
                            axisymmetric(report.probing) ? "2" : "", lost_in_words(state.control)));
    out +=
        fact(axisymmetric(report.probing) ? "Eq. (34)" : "Eq. (35)", roots_in_words(state.control));
  }
  if (report.many) {
    const auto first = report.first_unstable();
    const auto& s = report.states;
    out += fact("first", first ? fmt::format("unstable state of these: p′ {} kPa, η {}, α {}°",
                                             in_kPa(s[*first].p, 2), number(s[*first].eta(), 4),
                                             in_degrees(s[*first].circle.least.angle))
                               : "no unstable direction at any of these states");
  }
  std::vector<const StateHead*> heads;
  for (const ProbedState& state : report.states) heads.push_back(&state);
  for (const auto& warning : report.warnings) out += fact("warning", warning);
  for (const auto& warning : warnings_of(heads))
    if (std::ranges::find(report.warnings, warning) == report.warnings.end())
      out += fact("warning", warning);
  for (const ProbedState& state : report.states) {
    if ((details.probes || details.control) && report.states.size() > 1)
      out += '\n' + state_heading(state);
    if (details.control) out += '\n' + control_text(state.control);
    if (details.probes) out += '\n' + indented(to_text(probes_table(report, state)));
  }
  return without_controls(out);
}

}  // namespace triax::src
