// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/facts/undrained_strength_fact.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lab/measured/undrained_strength.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

std::string strength_at(const lab::Instant& at) {
  return fmt::format("c_u = {} kPa at {} % axial strain",
                     in_kPa(std::fabs(at.q_pa.value_or(0)) / 2), in_percent(at.axial_strain, 1));
}

std::string rule(const lab::UndrainedStrength& strength) {
  if (strength.peaked) return "peak of q / 2";
  if (strength.last_axial_strain >= lab::kIsoFailureStrain)
    return "q / 2; q had no peak before 20 %, the failure strain of ISO 17892-8";
  return fmt::format("q / 2; q was still rising when shear ended at {} %",
                     in_percent(strength.last_axial_strain, 1));
}

}  // namespace

std::vector<std::string> undrained_strength_lines(const lab::UndrainedStrength& strength) {
  std::vector<std::string> lines{fmt::format("{} ({})", strength_at(strength.at), rule(strength))};
  if (strength.at_15_pct)
    lines.push_back(strength_at(*strength.at_15_pct) +
                    " (q / 2; q had no peak before 15 %, the failure strain of ASTM D2850)");
  return lines;
}

}  // namespace triax::src
