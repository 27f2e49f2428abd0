// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/elastic.hpp"

#include <cmath>

namespace triax::sim {

const ParameterTable<ElasticParameters>& elastic_table() {
  static const ParameterTable<ElasticParameters> table = elastic_rows<ElasticParameters>();
  return table;
}

LawDescription elastic_law() {
  return describe<Elastic>(
      "elastic", "isotropic elasticity, linear or growing with a power of p'",
      "Hooke's law; the power of the mean stress after Janbu (1963), with an energy "
      "after Houlsby, Amorosi and Rojas (2005)",
      elastic_table());
}

double young_modulus(const ElasticParameters& p, double p_pa) {
  return p.pressure_exponent == 0
             ? p.young_modulus_pa
             : p.young_modulus_pa * std::pow(p_pa / p.reference_pressure_pa, p.pressure_exponent);
}

template <class Space>
Elastic<Space>::Elastic(const ElasticParameters& p) : parameters_(p) {
  check_parameters(p, elastic_table());
  check_hyperelastic(p.hyperelastic);
}

template <class Space>
void Elastic<Space>::response(const State& state, Response<Space>& out) const {
  stiffness_form(out).stiffness = elastic_stiffness<Space>(parameters_, state.stress);
}

template class Elastic<Axisymmetric>;
template class Elastic<Tensor>;

}  // namespace triax::sim
