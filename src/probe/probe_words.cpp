// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe_words.hpp"

#include <fmt/format.h>

#include "src/output/words.hpp"

namespace triax::src {

std::string plane_words(sim::ProbePlane plane) {
  return plane == sim::ProbePlane::axisymmetric
             ? "axisymmetric, α from √2 dσ₃ towards dσ₁ (Rendulic plane)"
             : "plane strain, α from dσ₃ towards dσ₁";
}

std::string probing_words(const study::Probing& probing) {
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

std::string cones_in_words(const sim::Circle& circle, int directions) {
  if (!circle.cones.empty() || circle.unanswered == 0) return cones_in_words(circle.cones);
  if (!circle.least.answered || circle.unanswered >= directions) return "unknown";
  return fmt::format("none found in the {} with a result", directions - circle.unanswered);
}

std::string unanswered_words(const study::ProbedState& state, int directions) {
  const int refused = state.circle.refused, beyond = state.circle.unanswered - refused;
  std::string words;
  if (beyond > 0) words = fmt::format("{} beyond the law's limit", beyond);
  if (refused > 0)
    words += fmt::format("{}{} rejected by the law{}{}", words.empty() ? "" : ", ", refused,
                         state.refusal.empty() ? "" : ": ", state.refusal);
  return words.empty() ? words : fmt::format("of {} directions {}", directions, words);
}

}  // namespace triax::src
