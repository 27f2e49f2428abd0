// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>
#include <memory>

#include "sim/materials/elastic.hpp"
#include "sim/specimen/specimen.hpp"
#include "tests/sim/materials/interpolated_laws.hpp"

// Specimens and boundaries of the tests of sim/specimen.
namespace triax::sim::test {

using LawPointer = std::shared_ptr<const Law<Axisymmetric>>;
using Axis = AxialDrive::Kind;
using Water = WaterDrive::Kind;

inline LawPointer inl2_law_of_s28() { return std::make_shared<Interpolated<Axisymmetric>>(inl2()); }
inline LawPointer sanisand_of_s28() {
  return std::make_shared<Sanisand<Axisymmetric>>(s28_general());
}
inline LawPointer linear_law(double young_pa, double nu) {
  ElasticParameters p;
  p.young_modulus_pa = young_pa;
  p.poisson_ratio = nu;
  p.reference_pressure_pa = 100e3;
  return std::make_shared<Elastic<Axisymmetric>>(p);
}

/// Without any imperfection.
inline SpecimenProperties bare() {
  SpecimenProperties p;
  p.height_m = 0.14;
  p.diameter_m = 0.07;
  return p;
}
/// With all that a real one has, but air and resistance.
inline SpecimenProperties real() {
  SpecimenProperties p = bare();
  p.water_compressibility = 1 / 2.2e9;
  p.system_compliance = 5e-13;
  p.membrane_thickness_m = 0.3e-3;
  p.membrane_young_modulus_pa = 1.4e6;
  p.membrane_penetration_m = 5e-6;
  return p;
}

inline Specimen loose(const LawPointer& law, const SpecimenProperties& properties,
                      double void_ratio = 1.086) {
  return {law, properties, void_ratio, 100e3, 300e3};
}

inline SpecimenBoundary moved(double velocity, Water water = Water::closed) {
  SpecimenBoundary b;
  b.axis.kind = Axis::rigid;
  b.axis.velocity_m_per_s = velocity;
  b.water.kind = water;
  b.water.back_pressure_pa = 300e3;
  return b;
}
/// q held with a cell pressure that changes.
inline SpecimenBoundary constant_q(double q_pa, double cell_rate, Water water) {
  SpecimenBoundary b = moved(0, water);
  b.axis.kind = Axis::force;
  b.axis.stress_pa = q_pa;
  b.cell_pressure_rate_pa_per_s = cell_rate;
  return b;
}
/// A dead load with mass.
inline SpecimenBoundary dead_load(double force_n, double mass_kg) {
  SpecimenBoundary b;
  b.axis.kind = Axis::force;
  b.axis.force_n = force_n;
  b.axis.mass_kg = mass_kg;
  b.axis.travel_m = 0.03;
  return b;
}

inline bool accepted(const SpecimenStep& step) { return step.outcome == StepOutcome::accepted; }

/// `count` steps of the same boundary; a back pressure that changes goes on.
inline SpecimenState run(const Specimen& specimen, SpecimenState state, SpecimenBoundary b,
                         double dt_s, int count) {
  for (int i = 0; i < count; ++i) {
    state = specimen.advance(state, b, dt_s).state;
    b.water.back_pressure_pa += b.water.back_pressure_rate_pa_per_s * dt_s;
  }
  return state;
}

/// Compressed (way 1) or extended (-1) at constant velocity until F has fallen by 3 % from its
/// peak: an equilibrium that no dead load holds.
inline SpecimenState past_peak(const Specimen& specimen, double way = 1) {
  SpecimenState state = specimen.start();
  double peak = 0;
  for (int i = 0; i < 5000 && way * specimen.axial_force(state) >= 0.97 * peak; ++i) {
    state = specimen.advance(state, moved(way * 1e-5), 0.25).state;
    peak = std::max(peak, way * specimen.axial_force(state));
  }
  return state;
}

/// Sheared drained to q and then at constant q with falling p′ to this stress ratio.
inline SpecimenState past_onset(const Specimen& specimen, double q_pa, double eta) {
  SpecimenState state = specimen.start();
  for (int i = 0; i < 5000 && state.material.q() < q_pa; ++i)
    state = specimen.advance(state, moved(2e-6, Water::drained), 0.5).state;
  const double held = specimen.axial_force(state) / specimen.area_m2(state);
  const SpecimenBoundary falling = constant_q(held, -50, Water::drained);
  for (int i = 0; i < 9000 && state.material.q() < eta * state.material.p(); ++i)
    state = specimen.advance(state, falling, 0.25).state;
  return state;
}

}  // namespace triax::sim::test
