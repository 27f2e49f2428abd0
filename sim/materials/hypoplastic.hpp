// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Hypoplasticity for sand (von Wolffersdorff 1996), with the intergranular strain of Niemunis and
// Herle (1997) where its range R is given. No yield surface: the response is nonlinear in |dε|.
//
//   dσ = L:dε − N |dε|
//   L = f_b f_e/(t:t) (F² I + a² t⊗t),   N = f_b f_e f_d a F/(t:t) (t + t*),
//     t = σ/tr σ,  t* = t − δ/3,  a = √3 (3 − sin φ_c)/(2√2 sin φ_c)
//   F = √(tan²ψ/8 + (2 − tan²ψ)/(2 + √2 tan ψ cos 3θ)) − tan ψ/(2√2),
//     tan ψ = √3 |t*|,  cos 3θ = −√6 tr t*³/|t*|³;  1 in compression, 1 − tan ψ/√2 in extension
//   e_i/e_i0 = e_c/e_c0 = e_d/e_d0 = exp(−(3p/h_s)ⁿ)
//   f_e = (e_c/e)^β,   f_d = ((e − e_d)/(e_c − e_d))^α,
//   f_b = h_s/n (e_i0/e_c0)^β (1 + e_i)/e_i (3p/h_s)^(1−n)
//         / (3 + a² − a√3 ((e_i0 − e_d0)/(e_c0 − e_d0))^α)
//
// Below e_d, where the root has no value, f_d = −(|e − e_d|/(e_c − e_d))^α. Above e_i the formulae
// hold as they are. Nothing is clipped on either side; warning() says that the state is outside.
//
// Intergranular strain h, ĥ = h/|h|, ρ = |h|/R ≤ 1:
//
//   dσ = [ρ^χ m_T + (1 − ρ^χ) m_R] L:dε + ρ^χ (1 − m_T) (L:ĥ)(ĥ:dε) − ρ^χ N ĥ:dε    where ĥ:dε > 0
//                                       + ρ^χ (m_R − m_T) (L:ĥ)(ĥ:dε)               elsewhere
//   dh = dε − ρ^β_r ĥ ⟨ĥ:dε⟩
//
// Both branches are linear, so that ĥ:dε > 0 is a mechanism. ĥ has no value at h = 0, nor is one
// needed: everything that it enters vanishes with ρ.
//
// In undrained triaxial compression q has its peak, and at constant q the volume begins to
// contract, at η = M_c (f_d − √(f_d² − 1)), M_c = 6 sin φ_c/(3 − sin φ_c) (without h).
//
// p is p′ (Pa), compression positive. Memory: none, or the components of h.
#include "sim/law/parameters.hpp"

namespace triax::sim {

struct HypoplasticParameters {
  double critical_friction_angle = 0;        ///< φ_c, rad
  double granulate_hardness_pa = 0;          ///< h_s
  double pressure_exponent = 0;              ///< n
  double densest_void_ratio = 0;             ///< e_d0, at p′ = 0
  double critical_void_ratio = 0;            ///< e_c0, at p′ = 0
  double loosest_void_ratio = 0;             ///< e_i0, at p′ = 0
  double peak_exponent = 0;                  ///< α
  double stiffness_exponent = 0;             ///< β
  double intergranular_range = 0;            ///< R; 0: without intergranular strain
  double reversal_factor = 5;                ///< m_R
  double transverse_factor = 2;              ///< m_T
  double intergranular_rate_exponent = 0.5;  ///< β_r
  double intergranular_exponent = 6;         ///< χ
  double intergranular_start = 1;            ///< ρ of a consolidated specimen
};

/// Key, symbol, unit and range of each parameter.
const ParameterTable<HypoplasticParameters>& hypoplastic_table();
LawDescription hypoplastic_law();

template <class Space>
class Hypoplastic : public Law<Space> {
 public:
  using State = PointState<Space>;

  /// Throws std::invalid_argument (parameter, value found, what would be right).
  explicit Hypoplastic(const HypoplasticParameters& parameters);

  const HypoplasticParameters& parameters() const { return parameters_; }

  /// Intergranular strain as isotropic consolidation leaves it: h = ρ R/√3 δ, ρ a parameter.
  State start(const Vector<Space>& stress, double void_ratio) const override;
  std::vector<std::string> memory_names() const override;
  double memory_scale(int) const override { return parameters_.intergranular_range; }
  /// Refuses what the base does, a principal stress that is not above 0, and p′ below 1 Pa, to
  /// which loose sand comes within a finite strain.
  std::optional<std::string> objection(const State& state) const override;
  /// Void ratio above e_i or below e_d.
  std::optional<std::string> warning(const State& state) const override;
  using Law<Space>::response;
  void response(const State& state, Response<Space>& out) const override;
  void memory_rate(const State& state, const Response<Space>& response,
                   const PointRate<Space>& rate, Memory& out) const override;
  /// Takes back what round-off has brought |h| beyond R.
  void settle(State& state, unsigned on_yield) const override;
  std::optional<double> limit_stress_ratio() const override { return critical_ratio_; }

  bool has_intergranular_strain() const { return parameters_.intergranular_range > 0; }
  /// |h|/R
  double mobilisation(const State& state) const {
    return state.memory.norm() / parameters_.intergranular_range;
  }
  /// exp(−(3p/h_s)ⁿ): what the three limiting void ratios have fallen to.
  double compression(double p) const;
  /// f_d
  double density_factor(const State& state) const;
  /// η of the instability line in compression at this p′ and e; empty where f_d < 1: there is none.
  std::optional<double> instability_stress_ratio(const State& state) const;

 private:
  static constexpr int kSize = Space::kSize;
  void linear_and_norm(const State& state, Matrix<Space>& linear, Vector<Space>& norm) const;
  void add_intergranular(const State& state, StiffnessForm<Space>& form) const;

  HypoplasticParameters parameters_;
  double a_ = 0;
  double critical_ratio_ = 0;  ///< M_c
  double barotropy_ = 0;       ///< the constant part of f_b, Pa
  double log_hardness_ = 0;    ///< ln h_s
};

extern template class Hypoplastic<Axisymmetric>;
extern template class Hypoplastic<Tensor>;

}  // namespace triax::sim
