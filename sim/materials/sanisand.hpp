#pragma once
// SANISAND 2004 (Dafalias and Manzari 2004) in its triaxial form, compression and extension.
//
//   G = G₀ p_at (2.97 − e)²/(1 + e) √(p/p_at)      K = 2(1 + ν)/(3(1 − 2ν)) G
//   ψ = e − e_c,  e_c = e₀ − λ (p/p_at)^ξ
//   yield |η − α| = m;  s = +1 on the compression side, −1 on the extension side
//   M_b = M_s exp(−n_b ψ),  M_d = M_s exp(n_d ψ),  M_s = M or cM
//   dε_q^p = s L,  s dη = H L,  H = h (M_b − sη),  h = G₀ h₀ (1 − c_h e)/(√(p/p_at) |α − α_in|)
//   dε_v^p = D L,  D = A₀ (1 + ⟨s z⟩)(M_d − sη)
//   dz = −c_z ⟨−dε_v^p⟩ (s z_max + z);  α_in = α where s (α − α_in) < 0
//
// p is p′ (Pa), compression positive; no other stress enters. Two bounds of the law are handled
// openly: it has no meaning where 1 − c_h e ≤ 0 (such states are refused), and its contraction
// fades below p′ = 0.02 p_at as x²(3 − 2x), x = p′/(0.02 p_at), since K ~ √p′ would otherwise carry
// a liquefying specimen to p′ = 0 at a finite strain.
#include <Eigen/Core>
#include <optional>
#include <string>

#include "sim/materials/elastoplastic_tangent.hpp"

namespace triax::sim {

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

struct SanisandState {
  double p = 0;  ///< p′, Pa, > 0
  double q = 0;  ///< Pa
  double void_ratio = 0;
  double alpha = 0;     ///< axis of the elastic wedge in stress ratio
  double alpha_in = 0;  ///< α at the last reversal of loading
  double fabric = 0;    ///< z
};

/// What changes per unit of progress; integrated by the point driver.
struct SanisandRate {
  Eigen::Vector2d stress = Eigen::Vector2d::Zero();  ///< (dp′, dq)
  double void_ratio = 0;
  double fabric = 0;
};

class Sanisand {
 public:
  using State = SanisandState;
  using Rate = SanisandRate;

  /// Throws std::invalid_argument (parameter, value found, what would be right).
  explicit Sanisand(const SanisandParameters& parameters);

  const SanisandParameters& parameters() const { return parameters_; }

  /// State after isotropic consolidation, without memory of shear. Pre-condition: admissible.
  static State isotropic(double p_pa, double void_ratio);

  /// Why the law has no meaning at this state; empty where it has one.
  std::optional<std::string> objection(const State& state) const;

  double shear_modulus(const State& state) const;
  double bulk_modulus(const State& state) const;
  double state_parameter(const State& state) const;

  /// Distance from the yield surface in stress ratio, |η − α| − m: negative inside.
  double yield_distance(const State& state) const;
  /// Whether a plastic increment is possible here, to a hair's breadth of round-off.
  bool on_yield(const State& state) const;

  /// The state put onto the yield surface on the side where it is, memory of the reversal set.
  /// Pre-condition: on_yield to the accuracy that matters to the caller.
  State at_yield(State state) const;

  /// Pre-condition: p > 0. Where the state is inside the yield surface only `elastic` has meaning.
  ElastoplasticTangent tangent(const State& state) const;

  /// Rate of all that changes with the stress rate, strain rate (ε_v, ε_q) and plastic strain rate.
  Rate rate(const State& state, const Eigen::Vector2d& stress, const Eigen::Vector2d& strain,
            const Eigen::Vector2d& plastic_strain) const;

  /// from + rate, where a plastic move keeps the state on the yield surface.
  State moved(State from, const Rate& rate, bool plastic) const;

  /// Largest error of a move in units of its natural scale (p′, 1, z_max).
  double error_measure(const Rate& error, const State& at) const;

 private:
  static double side(const State& state) { return state.q / state.p >= state.alpha ? 1 : -1; }
  double contraction_fade(double p) const;

  SanisandParameters parameters_;
};

inline SanisandRate operator*(double factor, SanisandRate r) {
  r.stress *= factor;
  r.void_ratio *= factor;
  r.fabric *= factor;
  return r;
}
inline SanisandRate operator+(SanisandRate a, const SanisandRate& b) {
  a.stress += b.stress;
  a.void_ratio += b.void_ratio;
  a.fabric += b.fabric;
  return a;
}

}  // namespace triax::sim
