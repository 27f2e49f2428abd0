// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/cam_clay.hpp"

#include <cmath>

namespace triax::sim {

const ParameterTable<CamClayParameters>& cam_clay_table() {
  using P = CamClayParameters;
  static const ParameterTable<P> table = {
      {{"compression_slope",
        "λ",
        "",
        "slope of e against ln p', normal consolidation",
        {.above = 0}},
       &P::compression_slope},
      {{"swelling_slope", "κ", "", "slope of e against ln p', swelling", {.above = 0}},
       &P::swelling_slope},
      {{"critical_stress_ratio", "M", "", "q/p' at critical state", {.above = 0}},
       &P::critical_stress_ratio},
      {{"poisson_ratio", "ν", "", "Poisson's ratio", {.above = -1, .below = 0.5}},
       &P::poisson_ratio},
      {{.key = "overconsolidation_ratio",
        .symbol = "OCR",
        .unit = "",
        .meaning = "p_c over that of a normally consolidated start",
        .range = {.at_least = 1},
        .usual = 1},
       &P::overconsolidation_ratio},
      {hyperelastic_choice(), &P::hyperelastic}};
  return table;
}

LawDescription cam_clay_law() {
  return describe<CamClay>("cam_clay", "Modified Cam-Clay, isotropic hardening, flow associated",
                           "Roscoe and Burland (1968), in Engineering Plasticity, p. 535",
                           cam_clay_table());
}

template <class Space>
CamClay<Space>::CamClay(const CamClayParameters& p) : parameters_(p) {
  check_parameters(p, cam_clay_table());
  check_hyperelastic(p.hyperelastic);
  if (!(p.swelling_slope < p.compression_slope))
    throw std::invalid_argument("swelling_slope is not below compression_slope, as it must be");
}

template <class Space>
double CamClay<Space>::surface_through(const Vector<Space>& stress) const {
  const double p = mean_stress<Space>(stress), q = deviator_stress<Space>(stress);
  const double ratio = q / (parameters_.critical_stress_ratio * p);
  return p * (1 + ratio * ratio);
}

template <class Space>
PointState<Space> CamClay<Space>::start(const Vector<Space>& stress, double void_ratio) const {
  return {stress, void_ratio,
          Memory::Constant(1, parameters_.overconsolidation_ratio * surface_through(stress))};
}

template <class Space>
double CamClay<Space>::memory_scale(int) const {
  return 1e5;
}

template <class Space>
std::optional<std::string> CamClay<Space>::objection(const State& state) const {
  if (auto general = Law<Space>::objection(state)) return general;
  if (!(preconsolidation(state) > 0)) return "the preconsolidation pressure is not above 0";
  return std::nullopt;
}

template <class Space>
double CamClay<Space>::bulk_modulus(const State& state) const {
  return (1 + state.void_ratio) * state.p() / parameters_.swelling_slope;
}

template <class Space>
void CamClay<Space>::response(const State& state, Response<Space>& out) const {
  const auto& par = parameters_;
  StiffnessForm<Space>& form = stiffness_form(out);
  const double bulk = bulk_modulus(state), nu = par.poisson_ratio;
  const double shear = 3 * (1 - 2 * nu) / (2 * (1 + nu)) * bulk;
  form.stiffness = par.hyperelastic != 0
                       ? hyperelastic_stiffness<Space>(state.stress, state.p(), 1, bulk, shear)
                       : isotropic_stiffness<Space>(bulk, shear);
  // ∂f/∂σ and ∂f/∂p_c, both over p_c, so that the measure of λ has no unit.
  const double p = state.p(), p_c = preconsolidation(state);
  const double m2 = par.critical_stress_ratio * par.critical_stress_ratio;
  const double volumetric = m2 * (2 * p - p_c) / p_c;
  const Vector<Space> normal =
      3 / p_c * deviator<Space>(state.stress) + volumetric / 3 * identity<Space>();
  const double growth =
      p_c * (1 + state.void_ratio) / (par.compression_slope - par.swelling_slope) * volumetric;
  form.add_plastic(normal, normal, m2 * p / p_c * growth);
  form.memory_slope[0].setConstant(1, growth);
}

template <class Space>
double CamClay<Space>::yield_distance(const State& state, int) const {
  return surface_through(state.stress) / preconsolidation(state) - 1;
}

template <class Space>
void CamClay<Space>::settle(State& state, unsigned on_yield) const {
  if (on_yield != 0) state.memory(0) = surface_through(state.stress);
}

template <class Space>
std::optional<double> CamClay<Space>::limit_stress_ratio() const {
  return parameters_.critical_stress_ratio;
}

template class CamClay<Axisymmetric>;
template class CamClay<Tensor>;

}  // namespace triax::sim
