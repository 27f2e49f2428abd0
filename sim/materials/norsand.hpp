// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// NorSand in triaxial compression (Jefferies 1993; Jefferies and Shuttle 2005; Jefferies and Been
// 2015), as a rate law with one yield surface.
//
//   critical state  e_c = Γ − λ ln(p/p_c), or where an exponent c is given e_c = Γ − λ (p/p_c)^c
//   state           ψ = e − e_c(p),  ψ_i = e − e_c(p_i);  p_i image pressure, r = p_i/p
//   elasticity      G = G_r (p/p_r)^n,  K = 2(1 + ν)/(3(1 − 2ν)) G
//   image           χ_i = χ/(1 − λ₀ χ/M),  M_i = M − χ_i N |ψ_i|
//   yield           q = p M_i (1 + ln r)
//   flow            dε_v^p = D dε_q^p,  D = M_i − q/p    (associated)
//   hardening       dp_i/p_i = [H r⁻² (r_max − r) + S] dε_q^p,
//                     H = max(H₀ − H_ψ ψ, 10),  r_max = exp(−χ_i ψ_i/M_i)
//   cap softening   S = −(η/η_L) D c_f K_S/p,  η_L = M_i − χ_i ψ_i,  c_f = 1/(1 + χ_i λ₀/M),
//                     K_S = K_w K/(K_w + K)
//
// λ₀ is −de_c/d ln p at the pressure p₀ of consolidation: λ itself, or λ c (p₀/p_c)^c. It is frozen
// there, p₀ being part of the memory. G_r, p_r are parameters, so that nothing else is frozen.
//
// S belongs to undrained loading only and a law does not know the drainage. It is told by a
// parameter, the bulk modulus K_w of the pore fluid: 0 for drained loading (S = 0), else that of
// the water. A set is for one of the two. The workbook that the published rows come from lets that
// water give way, dε_v + dp/K_w = 0; at dε_v = 0 exactly the undrained peak is up to three
// percent higher.
//
// What the law cannot follow is refused: see objection() and refusal().
//
// p is p′ (Pa), compression positive. Memory: p_i/p₀ and p₀ (Pa).
#include "sim/law/mark.hpp"
#include "sim/law/parameters.hpp"

namespace triax::sim {

struct NorSandParameters {
  double critical_stress_ratio = 0;       ///< M
  double volumetric_coupling = 0;         ///< N
  double state_dilatancy = 0;             ///< χ
  double hardening_modulus = 0;           ///< H₀
  double hardening_state_slope = 0;       ///< H_ψ
  double shear_modulus_pa = 0;            ///< G_r
  double shear_modulus_pressure_pa = 0;   ///< p_r
  double shear_modulus_exponent = 0;      ///< n
  double poisson_ratio = 0;               ///< ν
  double critical_void_ratio = 0;         ///< Γ
  double critical_slope = 0;              ///< λ
  double critical_exponent = 0;           ///< c; 0: logarithm
  double critical_pressure_pa = 1e3;      ///< p_c
  double pore_fluid_bulk_modulus_pa = 0;  ///< K_w; 0: drained
  double overconsolidation_ratio = 1;     ///< p_i over that on the yield surface, at the start
  double largest_state_parameter = 0.25;  ///< ψ from which on a state is refused
};

const ParameterTable<NorSandParameters>& norsand_table();
LawDescription norsand_law();

class NorSand : public Law<Axisymmetric> {
 public:
  using State = PointState<Axisymmetric>;
  using Rate = PointRate<Axisymmetric>;

  /// Throws std::invalid_argument (parameter, value found, what would be right).
  explicit NorSand(const NorSandParameters& parameters);

  const NorSandParameters& parameters() const { return parameters_; }

  /// Consolidated at this stress: p₀ = p, and p_i so that the yield surface passes through it,
  /// times the overconsolidation ratio.
  State start(const Vector<Axisymmetric>& stress, double void_ratio) const override;
  std::vector<std::string> memory_names() const override;
  double memory_scale(int entry) const override;
  /// Refuses, besides what the base does: p′ below 1 Pa; extension; a tensile principal stress; ψ
  /// above its limit; M_i ≤ 0; and
  /// a state inside the yield surface at the inner cap p = p_i/r_max. There a path of falling p′
  /// ends: inside the surface it is elastic, and the η at which it meets the cap depends on where
  /// it came from, so that no instability line exists (constant q with falling p′, that is CSD
  /// tests).
  std::optional<std::string> objection(const State& state) const override;
  /// Refuses directions that are neither undrained nor drained compression: falling p′ at constant
  /// q or, inside the yield surface, with rising η (CSD); isotropic loading; extension; and
  /// drainage that the set is not for.
  std::optional<std::string> refusal(const State& state, const Rate& rate) const override;
  /// Says of states inside the yield surface that they are elastic.
  std::optional<std::string> warning(const State& state) const override;
  using Law<Axisymmetric>::response;
  void response(const State& state, Response<Axisymmetric>& out) const override;
  /// η − M_i (1 + ln r)
  double yield_distance(const State& state, int mechanism) const override;
  /// Puts p_i so that the yield surface passes through the stress.
  void settle(State& state, unsigned on_yield) const override;
  std::optional<double> limit_stress_ratio() const override {
    return parameters_.critical_stress_ratio;
  }

  struct CriticalState {
    double void_ratio = 0;  ///< e_c
    double slope = 0;       ///< −de_c/d ln p
  };
  CriticalState critical_state(double p) const;
  double critical_void_ratio(double p) const { return critical_state(p).void_ratio; }
  double critical_slope(double p) const { return critical_state(p).slope; }
  double shear_modulus(double p) const;
  double bulk_modulus(double p) const { return bulk_ratio() * shear_modulus(p); }
  double state_parameter(const State& state) const {
    return state.void_ratio - critical_void_ratio(state.p());
  }
  /// H
  double hardening(const State& state) const;

  /// What follows from the image pressure.
  struct Image {
    double ratio = 0;            ///< r
    double critical_slope = 0;   ///< −de_c/d ln p at p_i
    double state_parameter = 0;  ///< ψ_i
    double dilatancy = 0;        ///< χ_i
    double stress_ratio = 0;     ///< M_i
    double largest_ratio = 0;    ///< r_max
    double limit = 0;            ///< η_L
  };
  /// Valid until the next call on this thread.
  const Image& image(const State& state) const;

  /// K_S; 0 in a set for drained loading.
  double restraint(const State& state) const { return restraint(bulk_modulus(state.p())); }
  /// S with this K_S (Pa).
  double cap_softening(const State& state, const Image& image, double restraint_pa) const;

  static double image_pressure(const State& s) { return s.memory(0) * s.memory(1); }

 private:
  Image image_at(double p, double void_ratio, double image_pressure, double p0) const;
  double consolidation_slope(double p0) const;
  double bulk_ratio() const;  ///< K/G
  double restraint(double skeleton_pa) const;
  std::optional<std::string> wrong_drainage(const State& state, const Rate& rate) const;
  void put_on_yield(State& state) const;

  NorSandParameters parameters_;
  Mark mark_;
};

}  // namespace triax::sim
