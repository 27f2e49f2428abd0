#pragma once
// A saturated cylinder of one material point: skeleton, pore water, what the water's lines store
// and the drainage resistance. Stresses and strains are homogeneous; there is no membrane, no
// inertia and no elasticity of the frame yet.
//
//   axial    natural strain dε₁ = −dH/H from the cap's displacement, or dq given (no piston: dq =
//   0) radial   σ₃′ + u = cell pressure water    V dε_v = C du + Q dt;  C = V_v/K_w + C_system;
//   valve open: Q = (u − u_b)/R, closed: Q = 0
//
// Strain increments are natural (per current height and volume), so that V = V_s (1 + e) and
// A = V/H hold exactly: reading A = A_c (1 − ε_v)/(1 − ε₁) back from engineering strains gives the
// same area. C = 0 (rigid water and lines) and R = 0 (u = u_b) are allowed.
#include <memory>

#include "sim/point/point_driver.hpp"

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

struct SpecimenState {
  PointState<Axisymmetric> material;
  double pore_pressure = 0;  ///< u, Pa
  double cell_pressure = 0;  ///< total radial stress, Pa
  double height_m = 0;
  double drained_volume_m3 = 0;  ///< water that left through the valve since the start
};

/// A drive that follows a force: the cap's velocity is gain · (wanted force − force), at most
/// `fastest` either way. The force is that at the end of the substep, so that any gain is stable.
/// While the specimen carries the load the error in force stays small; once it cannot, the drive
/// runs at its limit, q falls and the axial strain runs away: an honest run-away, but one without
/// inertia.
struct ForceServo {
  double wanted_force_n = 0;
  double gain_m_per_s_per_n = 0;
  double fastest_m_per_s = 0;
};

/// What the apparatus does during a step; rates are constant over it.
struct SpecimenBoundary {
  enum class Axial { displacement, deviator_stress, servo };
  Axial axial = Axial::displacement;
  double axial_rate = 0;  ///< of the cap, m/s, compression positive; or of q, Pa/s
  ForceServo servo;
  double cell_pressure_rate = 0;  ///< Pa/s
  bool valve_open = false;
  double back_pressure = 0;       ///< at the start of the step, Pa
  double back_pressure_rate = 0;  ///< Pa/s
};

struct SpecimenStep {
  StepOutcome outcome = StepOutcome::failed;
  SpecimenState state;  ///< at the end of what could be done
  double done_s = 0;
  AxisymmetricStress stress_increment;  ///< effective, of the part done
  AxisymmetricStrain strain_increment;  ///< natural, of the part done
  std::string message;                  ///< empty when accepted
  bool law_ended = false;               ///< failed because the law goes no further
};

class Specimen {
 public:
  using MaterialLaw = Law<Axisymmetric>;

  /// Throws std::invalid_argument if a dimension is not positive, a compliance or resistance
  /// negative or the law refuses the start.
  Specimen(std::shared_ptr<const MaterialLaw> law, const SpecimenProperties& properties,
           double void_ratio, double effective_stress_pa, double pore_pressure_pa);

  const MaterialLaw& law() const { return *law_; }
  const SpecimenState& start() const { return start_; }

  double volume_m3(const SpecimenState& s) const {
    return solid_volume_m3_ * (1 + s.material.void_ratio);
  }
  double area_m2(const SpecimenState& s) const { return volume_m3(s) / s.height_m; }
  /// Above the cell pressure, as an internal load cell sees it: F = q A.
  double axial_force(const SpecimenState& s) const { return s.material.q() * area_m2(s); }
  /// C, m³/Pa
  double water_compliance(const SpecimenState& s) const;

  /// The state dt later. Open drainage is integrated implicitly in u with error-controlled
  /// substeps; the result does not depend on dt beyond `pore_pressure_error_pa` per step. The given
  /// state is untouched whatever the outcome.
  SpecimenStep advance(const SpecimenState& state, const SpecimenBoundary& boundary, double dt_s,
                       double pore_pressure_error_pa = 2) const;

 private:
  SpecimenStep implicit_step(const SpecimenState& state, const SpecimenBoundary& boundary,
                             double elapsed_s, double dt_s) const;
  SpecimenStep mixed_step(const SpecimenState& state, const SpecimenBoundary& boundary,
                          double elapsed_s, double dt_s) const;

  std::shared_ptr<const MaterialLaw> law_;
  SpecimenProperties properties_;
  double solid_volume_m3_ = 0;
  SpecimenState start_;
};

}  // namespace triax::sim
