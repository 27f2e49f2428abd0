// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/sanisand.hpp"

#include <algorithm>
#include <cmath>

#include "sim/materials/component_names.hpp"

namespace triax::sim {
namespace {

/// p′/p_at below which the contraction is faded out.
constexpr double kFade = 0.02;

}  // namespace

const ParameterTable<SanisandParameters>& sanisand_table() {
  using P = SanisandParameters;
  static const ParameterTable<P> table = {
      {{"shear_modulus_factor", "G0", "", "shear modulus", {.above = 0}}, &P::shear_modulus_factor},
      {{"poisson_ratio", "ν", "", "Poisson's ratio", {.above = -1, .below = 0.5}},
       &P::poisson_ratio},
      {{"critical_stress_ratio",
        "M",
        "",
        "q/p' at critical state, compression",
        {.above = 0, .below = 3}},
       &P::critical_stress_ratio},
      {{"extension_ratio", "c", "", "M in extension over M", {.above = 0, .at_most = 1}},
       &P::extension_ratio},
      {{"critical_void_ratio", "e0", "", "critical void ratio at p' = 0", {.above = 0}},
       &P::critical_void_ratio},
      {{"critical_slope", "λ", "", "slope of the critical state line", {.at_least = 0}},
       &P::critical_slope},
      {{"critical_exponent", "ξ", "", "exponent of the critical state line", {.above = 0}},
       &P::critical_exponent},
      {{"yield_radius", "m", "", "radius of the yield surface", {.above = 0, .below = 0.2}},
       &P::yield_radius},
      {{"hardening_factor", "h0", "", "plastic modulus", {.above = 0}}, &P::hardening_factor},
      {{"hardening_void_ratio_factor",
        "c_h",
        "",
        "decrease of the plastic modulus with the void ratio",
        {.at_least = 0}},
       &P::hardening_void_ratio_factor},
      {{"bounding_exponent", "n_b", "", "bounding line with the state parameter", {.at_least = 0}},
       &P::bounding_exponent},
      {{"dilatancy_factor", "A0", "", "dilatancy", {.at_least = 0}}, &P::dilatancy_factor},
      {{"dilatancy_exponent",
        "n_d",
        "",
        "dilatancy line with the state parameter",
        {.at_least = 0}},
       &P::dilatancy_exponent},
      {{"fabric_limit", "z_max", "", "limit of the fabric tensor", {.at_least = 0}},
       &P::fabric_limit},
      {{"fabric_rate", "c_z", "", "growth of the fabric tensor with dilation", {.at_least = 0}},
       &P::fabric_rate},
      {{"atmospheric_pressure_kPa", "p_at", "kPa", "reference pressure", {.above = 0}},
       &P::atmospheric_pressure_pa}};
  return table;
}

LawDescription sanisand_law() {
  return describe<Sanisand>("sanisand", "SANISAND 2004, bounding surface plasticity with fabric",
                            "Dafalias and Manzari (2004), J. Eng. Mech. 130:622", sanisand_table());
}

template <class Space>
Sanisand<Space>::Sanisand(const SanisandParameters& p)
    : parameters_(p), bulk_ratio_(2 * (1 + p.poisson_ratio) / (3 * (1 - 2 * p.poisson_ratio))) {
  check_parameters(p, sanisand_table());
}

template <class Space>
PointState<Space> Sanisand<Space>::start(const Vector<Space>& stress, double void_ratio) const {
  State state{stress, void_ratio, Memory::Zero(3 * kSize)};
  // Consolidated under this stress: the yield surface stands around it.
  const Vector<Space> ratio = deviator<Space>(stress) / mean_stress<Space>(stress);
  if (ratio.norm() > kSanisandRoot * parameters_.yield_radius)
    state.memory.template segment<kSize>(0) =
        ratio * (1 - kSanisandRoot * parameters_.yield_radius / ratio.norm());
  return state;
}

template <class Space>
std::vector<std::string> Sanisand<Space>::memory_names() const {
  std::vector<std::string> names;
  for (const char* part : {"alpha", "alpha_in", "fabric"}) name_components<Space>(part, names);
  return names;
}

template <class Space>
double Sanisand<Space>::memory_scale(int entry) const {
  return entry < 2 * kSize ? 1 : 1 + parameters_.fabric_limit;
}

template <class Space>
std::optional<std::string> Sanisand<Space>::objection(const State& state) const {
  if (auto general = Law<Space>::objection(state)) return general;
  return objection(state.stress, state.void_ratio);
}

template <class Space>
std::optional<std::string> Sanisand<Space>::objection(const Vector<Space>& stress,
                                                      double void_ratio) const {
  if (!all_compressed<Space>(stress))
    return "a principal stress is tensile, which sand does not carry";
  if (void_ratio >= 2.97)
    return "the void ratio is " + short_number(void_ratio) + ", must be below 2.97";
  const double c_h = parameters_.hardening_void_ratio_factor;
  if (1 - c_h * void_ratio <= 0)
    return "the void ratio is " + short_number(void_ratio) +
           ", must be below 1/c_h = " + short_number(1 / c_h) +
           ", where this parameter set's hardening vanishes";
  return std::nullopt;
}

template <class Space>
std::optional<std::string> Sanisand<Space>::warning(const State& state) const {
  const double fade = kFade * parameters_.atmospheric_pressure_pa;
  if (state.p() >= fade) return std::nullopt;
  return "p' is below " + short_number(fade / 1e3) +
         " kPa, where the contraction of the law is reduced so that p' does not reach 0";
}

template <class Space>
double Sanisand<Space>::shear_at(double root_p, double void_ratio) const {
  const double gap = 2.97 - void_ratio;
  return parameters_.shear_modulus_factor * parameters_.atmospheric_pressure_pa * gap * gap /
         (1 + void_ratio) * root_p;
}

template <class Space>
double Sanisand<Space>::state_parameter_at(double relative_p, double void_ratio) const {
  return void_ratio - parameters_.critical_void_ratio +
         parameters_.critical_slope * std::pow(relative_p, parameters_.critical_exponent);
}

template <class Space>
double Sanisand<Space>::shear_modulus(const State& state) const {
  return shear_at(std::sqrt(state.p() / parameters_.atmospheric_pressure_pa), state.void_ratio);
}

template <class Space>
double Sanisand<Space>::bulk_modulus(const State& state) const {
  return bulk_ratio_ * shear_modulus(state);
}

template <class Space>
double Sanisand<Space>::state_parameter(const State& state) const {
  return state_parameter_at(state.p() / parameters_.atmospheric_pressure_pa, state.void_ratio);
}

template <class Space>
double Sanisand<Space>::yield_distance(const State& state, int) const {
  const Vector<Space> from_axis = deviator<Space>(state.stress) / state.p() - alpha(state);
  return from_axis.norm() - kSanisandRoot * parameters_.yield_radius;
}

template <class Space>
void Sanisand<Space>::settle(State& state, unsigned mechanisms) const {
  if (mechanisms == 0) return;
  const Vector<Space> ratio = deviator<Space>(state.stress) / state.p();
  const Vector<Space> from_axis = ratio - alpha(state);
  const double radius = kSanisandRoot * parameters_.yield_radius;
  state.memory.template segment<kSize>(0) = ratio - (radius / from_axis.norm()) * from_axis;
  if ((alpha(state) - alpha_in(state)).dot(from_axis) < 0)
    state.memory.template segment<kSize>(kSize) = alpha(state);
}

template <class Space>
double Sanisand<Space>::reversal(const State& state) const {
  // In axisymmetry n keeps its direction while the specimen loads.
  if constexpr (Space::kSize == 2) return 1;
  const Vector<Space> from_axis = deviator<Space>(state.stress) / state.p() - alpha(state);
  return (alpha(state) - alpha_in(state)).dot(from_axis) / parameters_.yield_radius;
}

template <class Space>
double Sanisand<Space>::contraction_fade(double p) const {
  const double x = p / (kFade * parameters_.atmospheric_pressure_pa);
  return x < 1 ? x * x * (3 - 2 * x) : 1;
}

template <class Space>
typename Sanisand<Space>::Standing Sanisand<Space>::standing(const State& state) const {
  const Vector<Space> a = alpha(state);
  Standing at{.p = state.p(), .void_ratio = state.void_ratio};
  at.ratio = deviator<Space>(state.stress) / at.p;
  at.n = at.ratio - a;
  const double size = at.n.norm();
  if (size > 0) at.n /= size;
  at.along = a.dot(at.n);
  at.fabric = std::max(0.0, fabric(state).dot(at.n));
  return at;
}

template <class Space>
typename Sanisand<Space>::Loading Sanisand<Space>::loading(const Standing& at) const {
  const auto& par = parameters_;
  Loading l;
  l.n = at.n;
  const Vector<Space> n2 = square<Space>(l.n);
  const double cosine = std::clamp(std::sqrt(6.0) * n2.dot(l.n), -1.0, 1.0);  // of 3θ
  const double c = par.extension_ratio;
  const double g = 2 * c / ((1 + c) - (1 - c) * cosine);
  const double relative_p = at.p / par.atmospheric_pressure_pa;
  const double psi = state_parameter_at(relative_p, at.void_ratio);
  const double limit = g * par.critical_stress_ratio;
  l.bounding = kSanisandRoot * (limit * std::exp(-par.bounding_exponent * psi) - par.yield_radius);
  const double dilatancy_line =
      kSanisandRoot * (limit * std::exp(par.dilatancy_exponent * psi) - par.yield_radius);
  l.dilatancy = par.dilatancy_factor * (1 + at.fabric) * (dilatancy_line - at.along);
  if (l.dilatancy > 0) l.dilatancy *= contraction_fade(at.p);
  const double b = 1 + 1.5 * (1 - c) / c * g * cosine;
  const double cc = 3 * std::sqrt(1.5) * (1 - c) / c * g;
  l.direction = b * l.n - cc * n2 + ((cc + l.dilatancy) / 3) * identity<Space>();
  l.normal = l.n - (l.n.dot(at.ratio) / 3) * identity<Space>();
  const double root_p = std::sqrt(relative_p);
  l.shear = shear_at(root_p, at.void_ratio);
  l.stiffness = par.shear_modulus_factor * par.hardening_factor *
                (1 - par.hardening_void_ratio_factor * at.void_ratio) / root_p;
  return l;
}

template <class Space>
void Sanisand<Space>::response(const State& state, Response<Space>& out) const {
  StiffnessForm<Space>& form = stiffness_form(out);
  const Standing at = standing(state);
  const Loading l = loading(at);
  const double distance = std::max(0.0, at.along - alpha_in(state).dot(l.n));
  const double shear = l.shear, bulk = bulk_ratio_ * shear;
  form.stiffness = isotropic_stiffness<Space>(bulk, shear);
  // K_p is multiplied by the distance since the last reversal, and the flow with it: both stay
  // finite, λ = L/distance.
  form.add_plastic(isotropic_product<Space>(bulk, shear, distance * l.direction),
                   isotropic_product<Space>(bulk, shear, l.normal), l.normal,
                   2.0 / 3 * at.p * l.stiffness * (l.bounding - at.along));
  Memory& slope = form.memory_slope[0];
  slope.setZero(3 * kSize);
  slope.template segment<kSize>(0) = 2.0 / 3 * l.stiffness * (l.bounding * l.n - alpha(state));
  if (l.dilatancy < 0)
    slope.template segment<kSize>(2 * kSize) = parameters_.fabric_rate * distance * l.dilatancy *
                                               (parameters_.fabric_limit * l.n + fabric(state));
}

template class Sanisand<Axisymmetric>;
template class Sanisand<Tensor>;

}  // namespace triax::sim
