// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Isotropic elasticity, linear or growing with the mean effective stress:
//
//   E = E_ref (p/p_ref)ⁿ,   K = E/(3(1 − 2ν)),   G = E/(2(1 + ν)),   dσ = K dε_v δ + 2G de
//
// p is p′ (Pa), compression positive. With n = 0 the law is linear and carries tension. With n > 0
// it is hypoelastic: a relation between rates that no energy stands behind, so that a closed cycle
// of strain that changes p and q together need not close in stress, and one of stress gains or
// loses work; it ends at p′ = 0. `hyperelastic` chooses the form that has an energy instead
// (sim/materials/hyperelastic.hpp), with the same E under isotropic stress.
//
// The plastic laws that are elastic within take the parameters and the stiffness from here.
#include "sim/materials/hyperelastic.hpp"

namespace triax::sim {

struct ElasticParameters {
  double young_modulus_pa = 0;       ///< E_ref
  double poisson_ratio = 0;          ///< ν
  double pressure_exponent = 0;      ///< n, 0: linear
  double reference_pressure_pa = 0;  ///< p_ref; without meaning where n = 0
  double hyperelastic = 0;           ///< 1: from an energy
};

/// Key, symbol, unit and range of each parameter, for a law whose parameters hold these.
template <class Parameters>
ParameterTable<Parameters> elastic_rows() {
  using P = Parameters;
  return {{{"young_modulus_kPa", "E_ref", "kPa", "Young's modulus at p_ref", {.above = 0}},
           &P::young_modulus_pa},
          {{"poisson_ratio", "ν", "", "Poisson's ratio", {.above = -1, .below = 0.5}},
           &P::poisson_ratio},
          {{.key = "pressure_exponent",
            .symbol = "n",
            .unit = "",
            .meaning = "growth of E with p', 0: none",
            .range = {.at_least = 0, .at_most = 1},
            .usual = 0},
           &P::pressure_exponent},
          {{.key = "reference_pressure_kPa",
            .symbol = "p_ref",
            .unit = "kPa",
            .meaning = "p' at which E is E_ref",
            .range = {.above = 0},
            .usual = 100},
           &P::reference_pressure_pa},
          {hyperelastic_choice(), &P::hyperelastic}};
}

const ParameterTable<ElasticParameters>& elastic_table();
LawDescription elastic_law();

/// E at p′. Pre-condition: p′ > 0 unless n = 0.
double young_modulus(const ElasticParameters& parameters, double p_pa);

/// C of a stress, Pa. Pre-condition: p′ > 0 unless n = 0.
template <class Space>
Matrix<Space> elastic_stiffness(const ElasticParameters& parameters, const Vector<Space>& stress) {
  const double nu = parameters.poisson_ratio, n = parameters.pressure_exponent;
  const bool potential = parameters.hyperelastic != 0 && n != 0;
  const double p = potential ? equivalent_pressure<Space>(stress, n, 2 * (1 + nu) / (3 - 6 * nu))
                             : mean_stress<Space>(stress);
  const double e = young_modulus(parameters, p);
  const double bulk = e / (3 * (1 - 2 * nu)), shear = e / (2 * (1 + nu));
  return potential ? hyperelastic_stiffness<Space>(stress, p, n, bulk, shear)
                   : isotropic_stiffness<Space>(bulk, shear);
}

template <class Space>
class Elastic : public Law<Space> {
 public:
  using State = PointState<Space>;

  /// Throws std::invalid_argument (parameter, value found, what would be right).
  explicit Elastic(const ElasticParameters& parameters);

  const ElasticParameters& parameters() const { return parameters_; }
  bool carries_tension() const override { return parameters_.pressure_exponent == 0; }
  using Law<Space>::response;
  void response(const State& state, Response<Space>& out) const override;

 private:
  ElasticParameters parameters_;
};

extern template class Elastic<Axisymmetric>;
extern template class Elastic<Tensor>;

}  // namespace triax::sim
