// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// SANISAND 2004 (Dafalias and Manzari 2004), multiaxial with fabric; in axisymmetry the same
// equations reduce to the triaxial form, compression and extension.
//
//   G = G₀ p_at (2.97 − e)²/(1 + e) √(p/p_at)      K = 2(1 + ν)/(3(1 − 2ν)) G
//   ψ = e − e_c,  e_c = e₀ − λ (p/p_at)^ξ
//   yield |s − pα| = √(2/3) m p;  r = s/p,  n = (r − α)/(√(2/3) m)
//   cos 3θ = √6 tr n³,  g = 2c/((1 + c) − (1 − c) cos 3θ)
//   α^b:n = √(2/3)(g M e^(−n_b ψ) − m),  α^d:n = √(2/3)(g M e^(n_d ψ) − m)
//   dε^p = L (R′ + D δ/3),  R′ = B n − C (n² − δ/3),
//     B = 1 + 3(1 − c)/(2c) g cos 3θ,  C = 3√(3/2) (1 − c)/c g,
//     D = A₀ (1 + ⟨z:n⟩)(α^d − α):n
//   dα = L ⅔ h (α^b − α),  K_p = ⅔ p h (α^b − α):n,
//     h = G₀ h₀ (1 − c_h e)/(√(p/p_at) (α − α_in):n)
//   dz = −c_z ⟨−L D⟩ (z_max n + z);  α_in = α where (α − α_in):n < 0
//
// p is p′ (Pa), compression positive; no other stress enters. Two bounds of the law are handled
// openly: it has no meaning where 1 − c_h e ≤ 0 (such states are refused), and its contraction
// fades below p′ = 0.02 p_at as x²(3 − 2x), x = p′/(0.02 p_at), since K ~ √p′ would otherwise carry
// a liquefying specimen to p′ = 0 at a finite strain.
//
// Memory: α, α_in, z, each with the components of the space.
#include <cmath>

#include "sim/law/parameters.hpp"

namespace triax::sim {

inline const double kSanisandRoot = std::sqrt(2.0 / 3);

struct SanisandParameters {
  double shear_modulus_factor = 0;         ///< G₀
  double poisson_ratio = 0;                ///< ν
  double critical_stress_ratio = 0;        ///< M, in compression
  double extension_ratio = 1;              ///< c = M_e/M
  double critical_void_ratio = 0;          ///< e₀, critical state line at p′ = 0
  double critical_slope = 0;               ///< λ
  double critical_exponent = 0;            ///< ξ
  double yield_radius = 0;                 ///< m
  double hardening_factor = 0;             ///< h₀
  double hardening_void_ratio_factor = 0;  ///< c_h
  double bounding_exponent = 0;            ///< n_b
  double dilatancy_factor = 0;             ///< A₀
  double dilatancy_exponent = 0;           ///< n_d
  double fabric_limit = 0;                 ///< z_max
  double fabric_rate = 0;                  ///< c_z
  double atmospheric_pressure_pa = 0;      ///< p_at
};

/// Key, symbol, unit and range of each parameter.
const ParameterTable<SanisandParameters>& sanisand_table();
LawDescription sanisand_law();

template <class Space>
class Sanisand : public Law<Space> {
 public:
  using State = PointState<Space>;

  /// Throws std::invalid_argument (parameter, value found, what would be right).
  explicit Sanisand(const SanisandParameters& parameters);

  const SanisandParameters& parameters() const { return parameters_; }

  State start(const Vector<Space>& stress, double void_ratio) const override;
  std::vector<std::string> memory_names() const override;
  double memory_scale(int entry) const override;
  std::optional<std::string> objection(const State& state) const override;
  std::optional<std::string> warning(const State& state) const override;
  using Law<Space>::response;
  void response(const State& state, Response<Space>& out) const override;
  double yield_distance(const State& state, int mechanism) const override;
  void settle(State& state, unsigned mechanisms) const override;
  double reversal(const State& state) const override;
  std::optional<double> limit_stress_ratio() const override {
    return parameters_.critical_stress_ratio;
  }

  double bulk_ratio() const { return bulk_ratio_; }  ///< K/G
  double shear_modulus(const State& state) const;
  double bulk_modulus(const State& state) const;
  double state_parameter(const State& state) const;

  // Parts of the memory.
  static auto alpha(const State& s) { return s.memory.template segment<Space::kSize>(0); }
  static auto alpha_in(const State& s) { return s.memory.template segment<Space::kSize>(kSize); }
  static auto fabric(const State& s) { return s.memory.template segment<Space::kSize>(2 * kSize); }

  /// Where a state stands on a yield surface.
  struct Standing {
    double p = 0, void_ratio = 0;
    Vector<Space> ratio;  ///< s/p
    Vector<Space> n;      ///< unit deviator from the axis of the surface to s/p
    double along = 0;     ///< α:n
    double fabric = 0;    ///< ⟨z:n⟩
  };
  struct Loading {
    Vector<Space> n;          ///< unit deviator
    Vector<Space> direction;  ///< R′ + D δ/3
    Vector<Space> normal;     ///< ∂f/∂σ
    double dilatancy = 0;     ///< D
    double bounding = 0;      ///< α^b:n
    double stiffness = 0;     ///< b₀ = h (α − α_in):n
    double shear = 0;         ///< G, Pa
  };
  Standing standing(const State& state) const;
  Loading loading(const Standing& at) const;
  Loading loading(const State& state) const { return loading(standing(state)); }
  /// Why there is no law at this stress (p′ > 0) and void ratio, whatever the memory.
  std::optional<std::string> objection(const Vector<Space>& stress, double void_ratio) const;

 private:
  static constexpr int kSize = Space::kSize;
  double contraction_fade(double p) const;
  double shear_at(double root_p, double void_ratio) const;  // √(p/p_at)
  double state_parameter_at(double relative_p, double void_ratio) const;

  SanisandParameters parameters_;
  double bulk_ratio_;  // K/G
};

extern template class Sanisand<Axisymmetric>;
extern template class Sanisand<Tensor>;

}  // namespace triax::sim
