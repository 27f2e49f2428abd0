// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/specimen.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "sim/specimen/inertial_motion.hpp"
#include "sim/specimen/pore_air.hpp"
#include "sim/specimen/quasi_static.hpp"
#include "sim/specimen/step_work.hpp"

namespace triax::sim {
namespace {

void check(const SpecimenProperties& p) {
  if (!(p.height_m > 0) || !(p.diameter_m > 0))
    throw std::invalid_argument("the specimen's height and diameter must be above 0");
  if (!(p.water_compressibility >= 0) || !(p.system_compliance >= 0) ||
      !(p.drainage_resistance >= 0))
    throw std::invalid_argument("compliances and the drainage resistance must be 0 or more");
  if (!(p.saturation > 0) || !(p.saturation <= 1))
    throw std::invalid_argument("the saturation must be above 0 and at most 1");
  if (!(p.membrane_thickness_m >= 0) || !(p.membrane_young_modulus_pa >= 0) ||
      !(p.membrane_penetration_m >= 0))
    throw std::invalid_argument(
        "the membrane's thickness, modulus and penetration must be 0 or more");
}

/// Losses of control within one step, each arrested, after which it is told as lost: a succession
/// without end.
constexpr int kMostRunAways = 20;

/// Why the drive cannot be what it says; empty where it can.
std::string objection(const AxialDrive& axis) {
  if (!(axis.mass_kg >= 0) || !(axis.damping_n_s_per_m >= 0) || !(axis.stiffness_n_per_m >= 0))
    return "mass, damping and stiffness of the axial drive must be 0 or more";
  if ((axis.inertial || axis.impulse_n_s != 0) &&
      !(axis.kind == AxialDrive::Kind::force && axis.mass_kg > 0))
    return "an impulse or inertia needs an axis driven by a force, with a mass above 0";
  return {};
}

}  // namespace

Specimen::Specimen(std::shared_ptr<const MaterialLaw> law, const SpecimenProperties& properties,
                   double void_ratio, double effective_stress_pa, double pore_pressure_pa)
    : law_(std::move(law)), properties_(properties) {
  check(properties);
  start_.material = law_->isotropic(effective_stress_pa, void_ratio);
  if (const auto objection = law_->objection(start_.material))
    throw std::invalid_argument(*objection);
  start_.pore_pressure = pore_pressure_pa;
  start_.cell_pressure = pore_pressure_pa + effective_stress_pa;
  start_.height_m = properties.height_m;
  const double d = properties.diameter_m, area = std::numbers::pi / 4 * d * d;
  solid_volume_m3_ = area * properties.height_m / (1 + void_ratio);
  start_volume_m3_ = volume_m3(start_);
  membrane_ =
      Membrane(4 * properties.membrane_young_modulus_pa * properties.membrane_thickness_m / d,
               properties.membrane_penetration_m * std::numbers::pi * d * properties.height_m,
               properties.height_m, start_volume_m3_, effective_stress_pa);
  water_ =
      PoreWater(properties.water_compressibility, properties.system_compliance, pore_pressure_pa);
  start_.air_pa_m3 = amount_of_air(void_volume_m3(start_), properties.saturation, pore_pressure_pa);
  start_water_m3_ = water(start_).amount_m3;
}

double Specimen::axial_force(const SpecimenState& s) const {
  return (s.material.q() + membrane_.axial_pa(s.height_m)) * area_m2(s);
}

double Specimen::water_compliance(const SpecimenState& s) const { return water(s).compliance; }

double Specimen::saturation(const SpecimenState& s) const {
  const double space = water_space_m3(s);
  return airy_space(space, s.pore_pressure, s.air_pa_m3).water_m3 / space;
}

double Specimen::enclosed_change_m3(const SpecimenState& s) const {
  return volume_m3(s) - start_volume_m3_ + membrane_.pocket_m3(radial_effective(s));
}

SpecimenStep Specimen::advance(const SpecimenState& state, const SpecimenBoundary& boundary,
                               double dt_s, const SpecimenTolerance& tolerance) const {
  SpecimenStep whole;
  whole.state = state;
  const AxialDrive& axis = boundary.axis;
  whole.message = objection(axis);
  if (!whole.message.empty()) return whole;
  whole.outcome = StepOutcome::accepted;

  const bool has_mass = axis.kind == AxialDrive::Kind::force && axis.mass_kg > 0;
  const QuasiStatic quasi_static(*this, boundary, tolerance, state.height_m);
  const InertialMotion motion(*this, boundary, tolerance, state.height_m);
  RunAway& run_away = whole.state.run_away;
  const auto kinetic = [&] {
    const double v = whole.state.velocity_m_per_s;
    return 0.5 * axis.mass_kg * v * v;
  };
  if (run_away.under_way && !has_mass) {  // another drive has caught the cap
    run_away.under_way = false;
    run_away.end = RunAway::End::arrested;
  }
  if (axis.impulse_n_s != 0) {
    if (!run_away.under_way) whole.state.velocity_m_per_s = 0;
    const double before = kinetic();
    whole.state.velocity_m_per_s += axis.impulse_n_s / axis.mass_kg;
    whole.work.impulse = kinetic() - before;
    whole.work.kinetic += whole.work.impulse;
  } else if (axis.inertial && !run_away.under_way) {
    whole.state.velocity_m_per_s = 0;
  }
  if ((axis.inertial || axis.impulse_n_s != 0) && !run_away.under_way) motion.begin(whole.state, 0);

  for (int lost = 0; whole.done_s < dt_s;) {
    if (run_away.under_way) {
      motion.run(whole, dt_s);
      if (!went_on(whole)) break;
      continue;
    }
    quasi_static.run(whole, dt_s);
    if (whole.outcome != StepOutcome::lost_control || !has_mass || ++lost > kMostRunAways) break;
    whole.outcome = StepOutcome::accepted;
    whole.message.clear();
    whole.work.kinetic += kinetic();
    whole.work.impulse += kinetic();  // of the quasi-static velocity
    motion.begin(whole.state, whole.done_s);
  }
  return whole;
}

}  // namespace triax::sim
