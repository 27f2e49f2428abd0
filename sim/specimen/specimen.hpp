// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A cylinder of one material point: skeleton, pore water with air, membrane, the water's lines and
// the drainage resistance. Stresses and strains are homogeneous.
//
//   axial    natural strain dε₁ = −dH/H of the cap's displacement; F = (q + m) A as an internal
//            load cell sees it, m the membrane's (membrane.hpp); what pushes: boundary.hpp
//   radial   σ₃′ + u + Δσ₃ₘ = cell pressure
//   water    V dε_v = C du − C_m dσ₃′ + Q dt (water.hpp): water, lines, air; membrane penetration
//
// Strain increments are natural (per current height and volume), so that V = V_s (1 + e) and
// A = V/H hold exactly: reading A = A_c (1 − ε_v)/(1 − ε₁) back from engineering strains gives the
// same area. Every compliance, resistance and mass may be 0: then the specimen is the bare material
// point.
#include <memory>

#include "sim/specimen/boundary.hpp"
#include "sim/specimen/membrane.hpp"
#include "sim/specimen/specimen_state.hpp"
#include "sim/specimen/water.hpp"

namespace triax::sim {

struct SpecimenProperties {
  double height_m = 0;               ///< as built, > 0
  double diameter_m = 0;             ///< as built, > 0
  double water_compressibility = 0;  ///< 1/K_w, 1/Pa; 0 is rigid water
  double system_compliance = 0;      ///< lines and transducer, m³/Pa
  double drainage_resistance = 0;    ///< R, Pa s/m³
  double saturation = 1;             ///< as built, at the initial pore pressure, above 0 to 1
  double membrane_thickness_m = 0;
  double membrane_young_modulus_pa = 0;
  double membrane_penetration_m = 0;  ///< m³ per m² of membrane and log₁₀ cycle of σ₃′
};

/// How closely a step is integrated.
struct SpecimenTolerance {
  PointTolerance point;            ///< of the material
  double pore_pressure_pa = 2;     ///< error per step through a drainage resistance
  double inertial_substep = 0.05;  ///< longest substep of inertial motion over √(m/|k|)
  /// Steps of the law's integration after which a step of the specimen is given up, as where the
  /// law goes no further: near p′ = 0 each is so short that there is no end to them.
  std::int64_t law_steps = 100000;
};

/// σ₃′, Pa
inline double radial_effective(const SpecimenState& s) {
  return axisymmetric_stress(s.material.stress).radial;
}

class Specimen {
 public:
  using MaterialLaw = Law<Axisymmetric>;

  /// Throws std::invalid_argument if a property is out of its range or the law refuses the start.
  Specimen(std::shared_ptr<const MaterialLaw> law, const SpecimenProperties& properties,
           double void_ratio, double effective_stress_pa, double pore_pressure_pa);

  const MaterialLaw& law() const { return *law_; }
  const SpecimenState& start() const { return start_; }
  const SpecimenProperties& properties() const { return properties_; }
  const Membrane& membrane() const { return membrane_; }

  double volume_m3(const SpecimenState& s) const {
    return solid_volume_m3_ * (1 + s.material.void_ratio);
  }
  double area_m2(const SpecimenState& s) const { return volume_m3(s) / s.height_m; }
  double displacement_m(const SpecimenState& s) const { return properties_.height_m - s.height_m; }
  /// Above the cell pressure, as an internal load cell sees it: F = (q + m) A.
  double axial_force(const SpecimenState& s) const;
  const PoreWater& pore_water() const { return water_; }
  double void_volume_m3(const SpecimenState& s) const {
    return solid_volume_m3_ * s.material.void_ratio;
  }
  /// Space of water and air: between the grains and behind the membrane, m³.
  double water_space_m3(const SpecimenState& s) const {
    return void_volume_m3(s) + membrane_.pocket_m3(radial_effective(s));
  }
  /// Water and lines at this instant.
  PoreWater::Content water(const SpecimenState& s) const {
    return water_.content(water_space_m3(s), s.pore_pressure, s.air_pa_m3);
  }
  /// C = dV_w/du at constant void ratio and σ₃′ of water, air and lines, m³/Pa.
  double water_compliance(const SpecimenState& s) const;
  /// Share of the voids that is water.
  double saturation(const SpecimenState& s) const;
  /// Volume of what the membrane encloses with the pores of its surface, less the start's: what the
  /// water in the cell sees. m³
  double enclosed_change_m3(const SpecimenState& s) const;
  /// Water that must be in specimen and lines: what was there at the start less what drained, m³.
  double water_due_m3(const SpecimenState& s) const {
    return start_water_m3_ - s.drained_volume_m3;
  }
  /// Water that must be there less what the state has room for (pores, penetration, air, compliance
  /// of water and lines), m³: round-off after every step that went to its end.
  double water_imbalance_m3(const SpecimenState& s) const {
    return water_due_m3(s) - water(s).amount_m3;
  }

  /// The state dt later. Given state and boundary are untouched whatever the outcome; see
  /// boundary.hpp for what is integrated. Open drainage is integrated implicitly in u with
  /// error-controlled substeps: the result does not depend on dt beyond the tolerance.
  SpecimenStep advance(const SpecimenState& state, const SpecimenBoundary& boundary, double dt_s,
                       const SpecimenTolerance& tolerance = {}) const;

 private:
  std::shared_ptr<const MaterialLaw> law_;
  SpecimenProperties properties_;
  Membrane membrane_;
  PoreWater water_;
  double solid_volume_m3_ = 0, start_volume_m3_ = 0, start_water_m3_ = 0;
  SpecimenState start_;
};

}  // namespace triax::sim
