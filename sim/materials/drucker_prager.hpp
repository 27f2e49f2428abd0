// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Drucker and Prager's cone, matched to Mohr and Coulomb's surface in triaxial compression; elastic
// within (sim/materials/elastic.hpp), perfectly plastic on it, flow not associated:
//
//   f = q − M_f p − k,   q = √(3/2)|s|
//   M_f = 6 sin φ/(3 − sin φ),  k = 6 c cos φ/(3 − sin φ),  M_g = 6 sin ψ/(3 − sin ψ)
//   dε^p = λ (3 s/(2q) − M_g/3 δ):   dε_v^p = −M_g dε_q^p
//
// p is p′ (Pa), compression positive. The cone has the same q in extension as in compression, where
// soil has less; for M_f > 3/2 (φ > 36.9°) its states in extension have a tensile axial stress,
// which warning() says. At the apex, M_f p + k = 0, the direction of flow is not defined: states
// there and beyond are refused.
#include "sim/materials/elastic.hpp"

namespace triax::sim {

struct DruckerPragerParameters : ElasticParameters {
  double friction_angle = 0;  ///< φ in triaxial compression, rad
  double cohesion_pa = 0;     ///< c
  double dilation_angle = 0;  ///< ψ, rad
};

const ParameterTable<DruckerPragerParameters>& drucker_prager_table();
LawDescription drucker_prager_law();

template <class Space>
class DruckerPrager : public Law<Space> {
 public:
  using State = PointState<Space>;

  /// Throws std::invalid_argument (parameter, value found, what would be right).
  explicit DruckerPrager(const DruckerPragerParameters& parameters);

  const DruckerPragerParameters& parameters() const { return parameters_; }
  double friction_slope() const { return friction_slope_; }  ///< M_f
  double dilation_slope() const { return dilation_slope_; }  ///< M_g
  double cohesion() const { return cohesion_; }              ///< k, Pa

  bool carries_tension() const override {
    return parameters_.cohesion_pa > 0 && parameters_.pressure_exponent == 0;
  }
  std::optional<std::string> objection(const State& state) const override;
  std::optional<std::string> warning(const State& state) const override;
  using Law<Space>::response;
  void response(const State& state, Response<Space>& out) const override;
  /// q over the strength at this p′, less 1.
  double yield_distance(const State& state, int mechanism) const override;
  void settle(State& state, unsigned on_yield) const override;
  std::optional<double> limit_stress_ratio() const override;

 private:
  double strength(double p) const { return friction_slope_ * p + cohesion_; }

  DruckerPragerParameters parameters_;
  double friction_slope_, dilation_slope_, cohesion_;
};

extern template class DruckerPrager<Axisymmetric>;
extern template class DruckerPrager<Tensor>;

}  // namespace triax::sim
