#include "sim/specimen/specimen.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace triax::sim {
namespace {

void add(SpecimenStep& whole, const SpecimenStep& part) {
  whole.state = part.state;
  whole.done_s += part.done_s;
  whole.stress_increment.axial += part.stress_increment.axial;
  whole.stress_increment.radial += part.stress_increment.radial;
  whole.strain_increment.axial += part.strain_increment.axial;
  whole.strain_increment.radial += part.strain_increment.radial;
  whole.outcome = part.outcome;
  whole.message = part.message;
  whole.law_ended = part.law_ended;
}

bool went_on(const SpecimenStep& step) {
  return step.outcome == StepOutcome::accepted || step.outcome == StepOutcome::inaccurate;
}

}  // namespace

Specimen::Specimen(std::shared_ptr<const MaterialLaw> law, const SpecimenProperties& properties,
                   double void_ratio, double effective_stress_pa, double pore_pressure_pa)
    : law_(std::move(law)), properties_(properties) {
  if (!(properties.height_m > 0) || !(properties.diameter_m > 0))
    throw std::invalid_argument("the specimen's height and diameter must be above 0");
  if (!(properties.water_compressibility >= 0) || !(properties.system_compliance >= 0) ||
      !(properties.drainage_resistance >= 0))
    throw std::invalid_argument("compliances and the drainage resistance must be 0 or more");
  start_.material = law_->isotropic(effective_stress_pa, void_ratio);
  if (const auto objection = law_->objection(start_.material))
    throw std::invalid_argument(*objection);
  start_.pore_pressure = pore_pressure_pa;
  start_.cell_pressure = pore_pressure_pa + effective_stress_pa;
  start_.height_m = properties.height_m;
  const double area = std::numbers::pi / 4 * properties.diameter_m * properties.diameter_m;
  solid_volume_m3_ = area * properties.height_m / (1 + void_ratio);
}

double Specimen::water_compliance(const SpecimenState& s) const {
  return solid_volume_m3_ * s.material.void_ratio * properties_.water_compressibility +
         properties_.system_compliance;
}

SpecimenStep Specimen::mixed_step(const SpecimenState& state, const SpecimenBoundary& boundary,
                                  double elapsed_s, double dt_s) const {
  SpecimenStep step;
  step.state = state;
  const double cell_increment = boundary.cell_pressure_rate * dt_s;
  const double back_pressure =
      boundary.back_pressure + boundary.back_pressure_rate * (elapsed_s + dt_s);

  const double r = 1 / std::numbers::sqrt2;  // a₃ from its orthonormal component
  MixedControl<Axisymmetric> control;
  if (boundary.axial == SpecimenBoundary::Axial::displacement) {
    const double shortening = boundary.axial_rate * dt_s / state.height_m;
    if (!(shortening < 1)) {
      step.message = "the cap would pass the base of the specimen";
      return step;
    }
    control.strain.row(0) << 1, 0;
    control.increment(0) = -std::log1p(-shortening);
  } else if (boundary.axial == SpecimenBoundary::Axial::deviator_stress) {
    control.stress.row(0) << 1, -r;
    control.increment(0) = boundary.axial_rate * dt_s;
  } else {
    // H dε₁ = g (F_wanted − F − A dq) dt
    const double reach = boundary.servo.gain_m_per_s_per_n * dt_s;
    const double force = reach * area_m2(state);
    control.strain.row(0) << state.height_m, 0;
    control.stress.row(0) << force, -force * r;
    control.increment(0) = reach * (boundary.servo.wanted_force_n - axial_force(state));
  }
  // Water with du = dσ_c − dσ₃′ put in; nothing is divided by a compliance that may be zero.
  const double resistance = properties_.drainage_resistance;
  if (boundary.valve_open && resistance == 0) {
    control.stress.row(1) << 0, r;
    control.increment(1) = cell_increment - (back_pressure - state.pore_pressure);
  } else {
    const double volume = volume_m3(state);
    const double conductance = boundary.valve_open ? dt_s / resistance : 0;
    const double storage = (water_compliance(state) + conductance) / volume;
    control.strain.row(1) << 1, 2 * r;
    control.stress.row(1) << 0, storage * r;
    control.increment(1) =
        storage * cell_increment + conductance / volume * (state.pore_pressure - back_pressure);
  }

  const auto point = advance_point(*law_, state.material, control);
  step.outcome = point.outcome;
  step.message = point.message;
  step.law_ended = point.outcome == StepOutcome::failed;
  step.done_s = point.done * dt_s;
  step.stress_increment = axisymmetric_stress(point.stress_increment);
  step.strain_increment = axisymmetric_strain(point.strain_increment);
  step.state.material = point.state;
  step.state.height_m = state.height_m * std::exp(-step.strain_increment.axial);
  step.state.cell_pressure += point.done * cell_increment;
  const double du = point.done * cell_increment - step.stress_increment.radial;
  step.state.pore_pressure += du;
  if (boundary.valve_open)
    step.state.drained_volume_m3 +=
        volume_m3(state) - volume_m3(step.state) - water_compliance(state) * du;
  return step;
}

SpecimenStep Specimen::implicit_step(const SpecimenState& state, const SpecimenBoundary& boundary,
                                     double elapsed_s, double dt_s) const {
  if (boundary.axial != SpecimenBoundary::Axial::servo)
    return mixed_step(state, boundary, elapsed_s, dt_s);
  SpecimenStep followed = mixed_step(state, boundary, elapsed_s, dt_s);
  const double farthest = boundary.servo.fastest_m_per_s * dt_s;
  const double moved = state.height_m - followed.state.height_m;
  if (went_on(followed) && std::abs(moved) <= farthest) return followed;

  SpecimenBoundary at_limit = boundary;
  at_limit.axial = SpecimenBoundary::Axial::displacement;
  at_limit.axial_rate = boundary.servo.wanted_force_n >= axial_force(state)
                            ? boundary.servo.fastest_m_per_s
                            : -boundary.servo.fastest_m_per_s;
  return mixed_step(state, at_limit, elapsed_s, dt_s);
}

SpecimenStep Specimen::advance(const SpecimenState& state, const SpecimenBoundary& boundary,
                               double dt_s, double pore_pressure_error_pa) const {
  const bool stiff = boundary.valve_open && properties_.drainage_resistance > 0;
  if (!stiff) return implicit_step(state, boundary, 0, dt_s);

  SpecimenStep whole;
  whole.state = state;
  whole.outcome = StepOutcome::accepted;
  const double smallest = 1e-6 * dt_s;
  double h = dt_s;
  while (whole.done_s < dt_s) {
    h = std::min(h, dt_s - whole.done_s);
    const SpecimenStep full = implicit_step(whole.state, boundary, whole.done_s, h);
    SpecimenStep half = implicit_step(whole.state, boundary, whole.done_s, h / 2);
    if (went_on(half)) {
      const SpecimenStep second = implicit_step(half.state, boundary, whole.done_s + h / 2, h / 2);
      add(half, second);
    }
    const double error = std::abs(full.state.pore_pressure - half.state.pore_pressure);
    const double allowed = pore_pressure_error_pa * std::max(h / dt_s, 1e-3);
    const bool good = went_on(full) && went_on(half) && error <= allowed;
    if (!good && h > smallest) {
      h = std::max(h / 4, smallest);
      continue;
    }
    const double before = whole.done_s;
    add(whole, half);
    if (!went_on(half)) return whole;
    whole.done_s = h >= dt_s - before ? dt_s : before + h;
    if (error < allowed / 4) h *= 2;
  }
  return whole;
}

}  // namespace triax::sim
