// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/drucker_prager.hpp"

#include <cmath>

#include "sim/materials/strength.hpp"

namespace triax::sim {

const ParameterTable<DruckerPragerParameters>& drucker_prager_table() {
  static const auto table = elastic_and_strength_rows<DruckerPragerParameters>();
  return table;
}

LawDescription drucker_prager_law() {
  return describe<DruckerPrager>(
      "drucker_prager", "perfect plasticity on a cone, flow not associated",
      "Drucker and Prager (1952), Q. Appl. Math. 10:157", drucker_prager_table());
}

template <class Space>
DruckerPrager<Space>::DruckerPrager(const DruckerPragerParameters& p)
    : parameters_(p),
      friction_slope_(stress_ratio_at_friction_angle(p.friction_angle)),
      dilation_slope_(stress_ratio_at_friction_angle(p.dilation_angle)),
      cohesion_(6 * p.cohesion_pa * std::cos(p.friction_angle) / (3 - std::sin(p.friction_angle))) {
  check_parameters(p, drucker_prager_table());
  check_hyperelastic(p.hyperelastic);
  check_strength(p);
}

template <class Space>
std::optional<std::string> DruckerPrager<Space>::objection(const State& state) const {
  if (auto general = Law<Space>::objection(state)) return general;
  if (!(strength(state.p()) > 0))
    return "the mean stress is at the apex of the cone or beyond, where the law ends";
  return std::nullopt;
}

template <class Space>
std::optional<std::string> DruckerPrager<Space>::warning(const State& state) const {
  if (yield_distance(state, 0) > kFarOutside) return "the stress lies outside the yield surface";
  if (parameters_.cohesion_pa == 0 && !all_compressed<Space>(state.stress))
    return "a principal stress is tensile, which the cone allows and soil does not";
  return std::nullopt;
}

template <class Space>
void DruckerPrager<Space>::response(const State& state, Response<Space>& out) const {
  StiffnessForm<Space>& form = stiffness_form(out);
  form.stiffness = elastic_stiffness<Space>(parameters_, state.stress);
  Vector<Space> direction = deviator<Space>(state.stress);
  if (!(direction.norm() > 0)) direction = deviator<Space>(Vector<Space>::Unit(0));
  direction *= std::sqrt(1.5) / direction.norm();
  form.add_plastic(direction - dilation_slope_ / 3 * identity<Space>(),
                   direction - friction_slope_ / 3 * identity<Space>(), 0);
}

template <class Space>
double DruckerPrager<Space>::yield_distance(const State& state, int) const {
  return std::abs(deviator_stress<Space>(state.stress)) / strength(state.p()) - 1;
}

template <class Space>
void DruckerPrager<Space>::settle(State& state, unsigned on_yield) const {
  const double distance = yield_distance(state, 0);
  if (on_yield == 0 || distance > kFarOutside) return;
  state.stress -= distance / (1 + distance) * deviator<Space>(state.stress);
}

template <class Space>
std::optional<double> DruckerPrager<Space>::limit_stress_ratio() const {
  if (cohesion_ > 0) return std::nullopt;
  return friction_slope_;
}

template class DruckerPrager<Axisymmetric>;
template class DruckerPrager<Tensor>;

}  // namespace triax::sim
