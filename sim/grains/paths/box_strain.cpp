// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/paths/box_strain.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/grains/engine/guarded_steps.hpp"
#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::sim {
namespace {

constexpr double kRadialShare = 1 / std::numbers::sqrt2;  // of a₃ in √2 a₃
constexpr std::int64_t kRestingCrossings = 2;

double side(const GrainBox& box) {
  return std::max({box.length_m(0), box.length_m(1), box.length_m(2)});
}

double mean_diameter(const GrainState& state) {
  double sum = 0;
  for (const Grain& g : state.grains) sum += 2 * g.radius;
  return sum / static_cast<double>(state.grains.size());
}

/// |ε̇| at the bound, 1/s.
double fastest_rate(const GrainState& state, const StrainPace& pace) {
  const double p = std::max(mean_stress(axisymmetric_stress(state)), pace.least_pressure_pa);
  return pace.inertial_number / mean_diameter(state) * std::sqrt(p / state.law.density_kg_per_m3);
}

/// Rises from 0 to 1 with level ends; its integral over 0 to 1 is ½.
double smooth(double x) { return 0.5 * (1 - std::cos(std::numbers::pi * x)); }

/// Share of the highest rate in step k of `rise` + `level` + `rise`; they sum to rise + level.
double share(std::int64_t k, std::int64_t rise, std::int64_t level) {
  const double at = static_cast<double>(k) + 0.5, ramp = static_cast<double>(rise);
  if (k < rise) return smooth(at / ramp);
  if (k < rise + level) return 1;
  return smooth((2 * ramp + static_cast<double>(level) - at) / ramp);
}

void drive(Grains& grains, const Vector<Axisymmetric>& rate) {
  grains.drive(
      triaxial_drives(strain_rate_drive(rate(0)), strain_rate_drive(kRadialShare * rate(1))));
}

}  // namespace

std::int64_t crossing_steps(const GrainState& state) {
  double solid = 0;
  for (const Grain& g : state.grains) solid += g.radius * g.radius * g.radius;
  const double density =
      state.law.density_kg_per_m3 * 4 * std::numbers::pi / 3 * solid / state.box.volume_m3();
  const double modulus = kWaveModulus * state.law.stiffness_over_diameter_pa;
  return 1 + static_cast<std::int64_t>(side(state.box) * std::sqrt(density / modulus) /
                                       state.time_step_s);
}

StrainSteps strain_steps(const GrainState& s, double size, const StrainPace& pace) {
  if (size == 0) return {};
  const double could_change = size * s.law.stiffness_over_diameter_pa;
  const double part = std::min(1.0, could_change / pace.small_stress_pa);
  const double at_bound = size / (fastest_rate(s, pace) * s.time_step_s);
  StrainSteps steps;
  steps.rise = static_cast<std::int64_t>(std::ceil(part * static_cast<double>(crossing_steps(s))));
  steps.level =
      std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(at_bound)) - steps.rise);
  steps.rest = kRestingCrossings * steps.rise;
  return steps;
}

void strain_box(Grains& grains, const Vector<Axisymmetric>& strain, const StrainSteps& steps) {
  if (steps.all() == 0) return;
  const double highest =
      1 / (static_cast<double>(steps.rise + steps.level) * grains.state().time_step_s);
  for (std::int64_t k = 0; k < 2 * steps.rise + steps.level; ++k) {
    drive(grains, highest * share(k, steps.rise, steps.level) * strain);
    advance(grains, 1);
  }
  drive(grains, Vector<Axisymmetric>::Zero());
  advance(grains, steps.rest);
}

}  // namespace triax::sim
