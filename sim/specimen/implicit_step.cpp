// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/implicit_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/specimen/step_work.hpp"

namespace triax::sim {
namespace {

constexpr double kRoot = 1 / std::numbers::sqrt2;  // a₃ from its orthonormal component
/// What the conditions may be missed by: force over itself, but at least over this share of that of
/// p′; water over the volume.
constexpr double kSmallForce = 1e-2;
constexpr double kForceMissed = 1e-10, kWaterMissed = 2e-13;
/// Flow through a resistance is told from the balance afterwards; its error over the volume.
constexpr double kFlowMissed = 1e-9;
constexpr int kIterations = 4;
/// A rate that would strain further than this within the step predicts nothing.
constexpr double kPredictable = 1e-3;

}  // namespace

struct ImplicitStep::Instant {
  double volume, height, q, radial, pore_pressure;
  double area, force, space;
};

struct ImplicitStep::Conditions {
  MixedControl<Axisymmetric> control;
  double cell_increment = 0;
  double force_missed = 0, water_missed = 0;  // in shares of what is allowed, at `about`
  bool linear = true;                         // as they stand they hold for every increment
  std::string objection;
};

double ImplicitStep::applied_force(const SpecimenState& state, double elapsed_s) const {
  const AxialDrive& axis = boundary_.axis;
  if (axis.kind == AxialDrive::Kind::free) return 0;
  return axis.force_n + axis.force_rate_n_per_s * elapsed_s -
         axis.stiffness_n_per_m * (height_at_start_m_ - state.height_m) +
         (axis.stress_pa + axis.stress_rate_pa_per_s * elapsed_s) * specimen_.area_m2(state);
}

ImplicitStep::Instant ImplicitStep::instant(const SpecimenState& start, const Increment& moved,
                                            double cell) const {
  Instant at;
  const Membrane& membrane = specimen_.membrane();
  const double volume = specimen_.volume_m3(start);
  at.volume = volume * std::exp(-moved.volume);
  at.height = start.height_m * std::exp(-moved.axial);
  at.q = start.material.q() + moved.q;
  at.radial = radial_effective(start) + moved.radial;
  at.pore_pressure = cell - membrane.radial_pa(at.volume) - at.radial;
  at.area = at.volume / at.height;
  at.force = (at.q + membrane.axial_pa(at.height)) * at.area;
  const double space =
      specimen_.void_volume_m3(start) + (at.volume - volume) + membrane.pocket_m3(at.radial);
  at.space = space;
  return at;
}

/// By what a self-driven law may miss conditions; 0 for any other.
DrivingTolerance ImplicitStep::allowed(const SpecimenState& start) const {
  return self_driven_ != nullptr ? self_driven_->tolerance(start.material) : DrivingTolerance{};
}

/// The conditions, linearised about an increment.
ImplicitStep::Conditions ImplicitStep::conditions(const SpecimenState& start, double elapsed_s,
                                                  double dt_s, const Increment& about) const {
  Conditions found;
  found.cell_increment = boundary_.cell_pressure_rate_pa_per_s * dt_s;
  const Instant at = instant(start, about, start.cell_pressure + found.cell_increment);
  if (boundary_.axis.kind == AxialDrive::Kind::rigid)
    move_cap(start, dt_s, found);
  else
    balance_force(start, at, elapsed_s + dt_s, about, found);
  balance_water(start, at, elapsed_s, dt_s, about, found);
  return found;
}

void ImplicitStep::move_cap(const SpecimenState& start, double dt_s, Conditions& found) const {
  const double shortening = boundary_.axis.velocity_m_per_s * dt_s / start.height_m;
  if (!(shortening < 1)) found.objection = "the cap would pass the base of the specimen";
  found.control.strain.row(0) << 1, 0;
  found.control.increment(0) = -std::log1p(-shortening);
}

void ImplicitStep::balance_force(const SpecimenState& start, const Instant& at, double end_s,
                                 const Increment& about, Conditions& found) const {
  const AxialDrive& axis = boundary_.axis;
  const Membrane& membrane = specimen_.membrane();
  const bool free = axis.kind == AxialDrive::Kind::free;
  const double stress = free ? 0 : axis.stress_pa + axis.stress_rate_pa_per_s * end_s;
  const double k = free ? 0 : axis.stiffness_n_per_m;
  const double load = free ? 0 : axis.force_n + axis.force_rate_n_per_s * end_s;
  const double missed = at.force - (load - k * (height_at_start_m_ - at.height) + stress * at.area);
  const double by_height =
      at.force + membrane.axial_slope_pa(at.height) * at.area + k * at.height - stress * at.area;
  const double by_volume = stress * at.area - at.force;
  found.control.stress.row(0) << at.area, -at.area * kRoot;
  found.control.strain.row(0) << by_height + by_volume, 2 * kRoot * by_volume;
  found.control.increment(0) =
      at.area * about.q + by_height * about.axial + by_volume * about.volume - missed;
  const double size =
      std::max(std::abs(at.force), kSmallForce * std::abs(start.material.p()) * at.area);
  found.force_missed =
      std::abs(missed) / std::max(kForceMissed * size, allowed(start).stress_pa * at.area);
  found.linear = !membrane.stiff() && k == 0 && load == 0 && start.material.q() == stress;
}

/// With du = dσ_c − dΔσ₃ₘ − dσ₃′ put in; nothing is divided by a compliance that may be 0.
void ImplicitStep::balance_water(const SpecimenState& start, const Instant& at, double elapsed_s,
                                 double dt_s, const Increment& about, Conditions& found) const {
  const WaterDrive& water = boundary_.water;
  const Membrane& membrane = specimen_.membrane();
  const double back =
      water.back_pressure_pa + water.back_pressure_rate_pa_per_s * (elapsed_s + dt_s);
  const double by_skin = membrane.radial_slope_pa(at.volume);
  const double resistance = specimen_.properties().drainage_resistance;
  const bool drained = water.kind == WaterDrive::Kind::drained;
  double by_volume = by_skin, by_radial = 1, missed = at.pore_pressure - back;
  if (drained && resistance == 0) {
    found.linear = found.linear && !membrane.stiff();
    found.water_missed = std::abs(missed) / std::max(kForceMissed * std::abs(start.material.p()),
                                                     allowed(start).stress_pa);
  } else {
    const double conductance = drained ? dt_s / resistance : 0;
    const bool given = water.kind == WaterDrive::Kind::flow;
    const double flowed =
        given ? water.flow_m3_per_s * dt_s : conductance * (at.pore_pressure - back);
    // What flows out takes its dissolved air along.
    const double dissolved = flowed > 0 ? specimen_.water(start).dissolved_pa : 0;
    const PoreWater::Content content = specimen_.pore_water().content(
        at.space, at.pore_pressure, start.air_pa_m3 - dissolved * flowed);
    missed = flowed + content.amount_m3 - specimen_.water_due_m3(start);
    const double storage = content.compliance + conductance * (1 - content.per_air * dissolved);
    by_volume = content.per_space * at.volume + storage * by_skin;
    by_radial = content.per_space * membrane.penetration_compliance(at.radial) + storage;
    const DrivingTolerance told = allowed(start);
    const double round_off = (drained ? kFlowMissed : kWaterMissed) * at.volume;
    found.water_missed = std::abs(missed) /
                         std::max(round_off, told.stress_pa * by_radial + told.strain * by_volume);
    found.linear = found.linear && !drained && by_radial == 0 && flowed == 0;
  }
  found.control.strain.row(1) << by_volume, 2 * kRoot * by_volume;
  found.control.stress.row(1) << 0, kRoot * by_radial;
  found.control.increment(1) = missed + by_volume * about.volume + by_radial * about.radial;
}

ImplicitStep::Increment ImplicitStep::predict(const SpecimenState& start,
                                              const Conditions& conditions) const {
  const auto rate = point_rate(specimen_.law(), start.material, conditions.control);
  if (!rate.controllable || !(rate.strain.norm() < kPredictable)) return {};
  return {deviator_stress<Axisymmetric>(rate.stress), kRoot * rate.stress(1), rate.strain(0),
          trace<Axisymmetric>(rate.strain)};
}

SpecimenStep ImplicitStep::integrate(const SpecimenState& start, const Conditions& conditions,
                                     double dt_s) const {
  SpecimenStep step;
  const auto point =
      advance_point(specimen_.law(), start.material, conditions.control, tolerance_.point);
  step.outcome = point.outcome;
  step.message = point.message;
  step.law_ended = point.outcome == StepOutcome::failed;
  step.done_s = point.done * dt_s;
  step.substeps = 1;
  step.law_steps = point.steps;
  step.stress_increment = axisymmetric_stress(point.stress_increment);
  step.strain_increment = axisymmetric_strain(point.strain_increment);
  SpecimenState& end = step.state;
  end = start;
  end.material = point.state;
  end.height_m = start.height_m * std::exp(-step.strain_increment.axial);
  end.cell_pressure += point.done * conditions.cell_increment;
  end.pore_pressure = end.cell_pressure - specimen_.membrane().radial_pa(specimen_.volume_m3(end)) -
                      radial_effective(end);
  if (step.done_s > 0) end.velocity_m_per_s = (start.height_m - end.height_m) / step.done_s;
  return step;
}

SpecimenStep ImplicitStep::take(const SpecimenState& state, double elapsed_s, double dt_s) const {
  const auto about = [&](const Increment& moved) {
    return conditions(state, elapsed_s, dt_s, moved);
  };
  Conditions asked = about({});
  SpecimenStep step;
  step.state = state;
  if (!asked.objection.empty()) {
    step.message = asked.objection;
    return step;
  }
  if (!asked.linear && !specimen_.law().finite()) asked = about(predict(state, asked));
  const double enough = self_driven_ != nullptr ? allowed(state).loosened : 1;
  for (int i = 0; i < kIterations; ++i) {
    SpecimenStep tried = integrate(state, asked, dt_s);
    tried.law_steps += step.law_steps;
    step.law_steps = tried.law_steps;
    if (i > 0 && !went_on(tried)) break;
    step = tried;
    const Increment moved{deviator_stress(tried.stress_increment), tried.stress_increment.radial,
                          tried.strain_increment.axial, volumetric_strain(tried.strain_increment)};
    if (asked.linear || !went_on(tried)) break;
    asked = about(moved);
    if (std::max(asked.force_missed, asked.water_missed) <= enough) break;
  }
  settle_water(state, step);
  return step;
}

/// Water that flowed, with its dissolved air. Through an open valve it is what the balance says.
void ImplicitStep::settle_water(const SpecimenState& start, SpecimenStep& step) const {
  SpecimenState& end = step.state;
  const bool drained = boundary_.water.kind == WaterDrive::Kind::drained;
  double flowed = 0;
  const double carried = start.air_pa_m3 > 0 ? specimen_.water(start).dissolved_pa : 0;
  if (boundary_.water.kind == WaterDrive::Kind::flow)
    flowed = boundary_.water.flow_m3_per_s * step.done_s;
  if (drained) {
    const double out = specimen_.water_imbalance_m3(end);
    flowed = out > 0 ? out / (1 - specimen_.water(end).per_air * carried) : out;
  }
  if (flowed > 0) end.air_pa_m3 = std::max(end.air_pa_m3 - carried * flowed, 0.0);
  end.drained_volume_m3 += drained ? specimen_.water_imbalance_m3(end) : flowed;
}

double ImplicitStep::stiffness(const SpecimenState& state, double direction) const {
  Conditions asked = conditions(state, 0, 0, {});
  asked.control.stress.row(0).setZero();
  asked.control.strain.row(0) << 1, 0;
  asked.control.increment << std::copysign(1e-6, direction), 0;
  const auto rate = point_rate(specimen_.law(), state.material, asked.control);
  if (!rate.controllable) return std::numeric_limits<double>::quiet_NaN();
  const Membrane& membrane = specimen_.membrane();
  const double area = specimen_.area_m2(state), force = specimen_.axial_force(state);
  const double slope = membrane.axial_slope_pa(state.height_m);
  const double change = area * deviator_stress<Axisymmetric>(rate.stress) +
                        (force + slope * area) * rate.strain(0) -
                        force * trace<Axisymmetric>(rate.strain);
  return change / (state.height_m * rate.strain(0));
}

bool ImplicitStep::sustains(const SpecimenState& state) const {
  Conditions asked = conditions(state, 0, 0, {});
  const double small = 1e-6 * specimen_.area_m2(state) * std::abs(state.material.p());
  for (const double force : {small, -small}) {
    asked.control.increment << force, 0;
    if (self_driven_ != nullptr) {
      if (!self_driven_->sustains(state.material, asked.control)) return false;
      continue;
    }
    if (!point_rate(specimen_.law(), state.material, asked.control).controllable) return false;
  }
  return true;
}

}  // namespace triax::sim
