// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace triax::sim {

/// Latex membrane around the specimen, placed without stress on the specimen as built (H_b, D_b,
/// V_b): a linear elastic tube of thickness t with Poisson's ratio 1/2, as in the correction of
/// ISO 17892-9, with engineering strains since then,
///
///   Δσ₁ₘ = (4Et/D_b)(ε₁ + ε_v/3)   axial,   Δσ₃ₘ = (4Et/D_b) ε_v/3   radial
///
/// The membrane carries them in the soil's stead: σ₃ = σ_c − Δσ₃ₘ, F = (q + Δσ₁ₘ − Δσ₃ₘ) A. It also
/// bulges into the pores of the surface: the water that stands between membrane and grains loses
///
///   s A_m log₁₀(σ₃′/σ₃′_start),   A_m = π D_b H_b,   C_m = s A_m/(ln 10 σ₃′)
///
/// so that a falling σ₃′ makes room for water. Pre-condition of what takes σ₃′: it is above 0;
/// below 1 Pa it counts as 1 Pa, where the membrane has long left the pores.
class Membrane {
 public:
  Membrane() = default;
  /// `modulus_pa` = 4Et/D_b, `penetration_m3` = s A_m.
  Membrane(double modulus_pa, double penetration_m3, double height_m, double volume_m3,
           double start_radial_pa);

  bool stiff() const { return modulus_pa_ > 0; }
  bool penetrates() const { return penetration_m3_ > 0; }

  /// m = Δσ₁ₘ − Δσ₃ₘ, Pa: what is left of it is (4Et/D_b) ε₁.
  double axial_pa(double height_m) const { return modulus_pa_ * (1 - height_m / height_m_); }
  /// dm/dε₁ (natural), Pa
  double axial_slope_pa(double height_m) const { return modulus_pa_ * height_m / height_m_; }
  /// Δσ₃ₘ, Pa
  double radial_pa(double volume_m3) const {
    return modulus_pa_ / 3 * (1 - volume_m3 / volume_m3_);
  }
  /// dΔσ₃ₘ/dε_v (natural), Pa
  double radial_slope_pa(double volume_m3) const {
    return modulus_pa_ / 3 * volume_m3 / volume_m3_;
  }
  /// Volume between membrane and grains less the start's, m³
  double pocket_m3(double radial_eff_pa) const;
  /// C_m, m³/Pa
  double penetration_compliance(double radial_eff_pa) const;

 private:
  double modulus_pa_ = 0, penetration_m3_ = 0;
  double height_m_ = 1, volume_m3_ = 1, start_radial_pa_ = 1;
};

}  // namespace triax::sim
