// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/membrane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace triax::sim {
namespace {
constexpr double kSmallest_pa = 1;
}

Membrane::Membrane(double modulus_pa, double penetration_m3, double height_m, double volume_m3,
                   double start_radial_pa)
    : modulus_pa_(modulus_pa),
      penetration_m3_(penetration_m3),
      height_m_(height_m),
      volume_m3_(volume_m3),
      start_radial_pa_(std::max(start_radial_pa, kSmallest_pa)) {}

double Membrane::pocket_m3(double radial_eff_pa) const {
  if (!penetrates()) return 0;
  return -penetration_m3_ * std::log10(std::max(radial_eff_pa, kSmallest_pa) / start_radial_pa_);
}

double Membrane::penetration_compliance(double radial_eff_pa) const {
  if (!(radial_eff_pa > kSmallest_pa)) return 0;
  return penetration_m3_ / (std::numbers::ln10 * radial_eff_pa);
}

}  // namespace triax::sim
