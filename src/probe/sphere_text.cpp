// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/sphere_text.hpp"

#include <fmt/format.h>

#include "src/output/simulated_head.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

std::string own_words(const study::ProbedSphere& state) {
  const lab::MeasuredIncrement& own = *state.test->increment;
  return fmt::format(
      "{}: α {}° ± {}° of the Rendulic plane, measured W₂ {} ± {}, of the law {}", state.name,
      in_degrees(own.angle, 1), in_degrees(own.angle_error, 1), number(own.normalised, 3),
      number(own.normalised_error, 3),
      number(state.own->answered ? std::optional(state.own->normalised) : std::nullopt, 3));
}

Table state_table(const study::SphereResult& result) {
  Table table;
  table.columns.push_back({"state", Align::left});
  for (const char* heading : {"p′ (kPa)", "q (kPa)", "η", "e", "unstable (% of directions)",
                              "regions", "least W₂", "in direction (1, 2, 3)", "least of all six"})
    table.columns.push_back({heading, Align::right});
  int count = 0;
  for (const study::ProbedSphere& state : result.states) {
    const auto& least = state.sphere.least;
    const auto& d = least.direction;
    table.rows.push_back(
        {state.name.empty() ? fmt::format("{}", ++count) : state.name, in_kPa(state.p, 2),
         in_kPa(state.q, 2), number(state.eta(), 4), number(state.void_ratio, 4),
         in_percent(state.sphere.unstable_share, 2), fmt::format("{}", state.sphere.regions),
         number(least.answered ? std::optional(least.normalised) : std::nullopt, 4),
         least.answered
             ? fmt::format("{}, {}, {}", number(d(0), 3), number(d(1), 3), number(d(2), 3))
             : kUnknown,
         number(state.least.answered ? std::optional(state.least.normalised) : std::nullopt, 4)});
  }
  return table;
}

}  // namespace

std::string sphere_probing_words(const study::SphereProbing& probing) {
  const bool stress = probing.kind == sim::ProbeKind::stress;
  return fmt::format("{} of {:g}{}, {} rings of {} directions, by the rate at the state",
                     stress ? "stress" : "strain", stress ? probing.norm / 1e3 : probing.norm,
                     stress ? " kPa" : "", probing.rings, 2 * probing.rings);
}

std::string sphere_text(const study::SphereResult& result) {
  std::string out =
      simulated_head("Second-order work in every direction of space", result.material);
  out += fact("probes", sphere_probing_words(result.probing));
  out += fact("path", result.path);
  out += '\n' + indented(to_text(state_table(result)));
  out +=
      "  directions of principal increments along the axes of the state; the last column is over\n"
      "  all six components, rotations of the axes included\n\n";
  for (const study::ProbedSphere& state : result.states)
    if (state.own) out += fact("increment", own_words(state));
  std::vector<const study::StateHead*> heads;
  for (const study::ProbedSphere& state : result.states) heads.push_back(&state);
  for (const auto& warning : result.warnings) out += fact("warning", warning);
  for (const auto& warning : study::warnings_of(heads)) out += fact("warning", warning);
  return without_controls(out);
}

}  // namespace triax::src
