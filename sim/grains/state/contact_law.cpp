// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/contact_law.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace triax::sim {

double normal_stiffness(const ContactLaw& law, double radius1_m, double radius2_m) {
  const double in_series =
      2 * law.stiffness_over_diameter_pa * radius1_m * radius2_m / (radius1_m + radius2_m);
  return law.reading == StiffnessReading::in_series ? in_series : 2 * in_series;
}

double wall_stiffness(const ContactLaw& law, double radius_m) {
  return normal_stiffness(law, radius_m, radius_m);
}

double friction_coefficient(const ContactLaw& law) { return std::tan(law.friction_angle); }

void check(const ContactLaw& law) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  if (!positive(law.stiffness_over_diameter_pa))
    throw std::invalid_argument("contact law: stiffness over diameter must be above 0");
  if (!(law.tangential_ratio >= 0 && std::isfinite(law.tangential_ratio)))
    throw std::invalid_argument("contact law: k_t/k_n must not be below 0");
  if (!(law.friction_angle >= 0 && law.friction_angle < std::numbers::pi / 2))
    throw std::invalid_argument("contact law: friction angle must be from 0 to below pi/2 rad");
  if (!positive(law.density_kg_per_m3))
    throw std::invalid_argument("contact law: density must be above 0");
  if (!(law.damping >= 0 && law.damping < 1))
    throw std::invalid_argument("contact law: damping must be from 0 to below 1");
}

}  // namespace triax::sim
