// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/hypoplastic.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "sim/materials/component_names.hpp"

namespace triax::sim {
namespace {

using std::numbers::sqrt2;
const double kRoot3 = std::sqrt(3.0);
constexpr double kLiquefied = 1;  // Pa; above e_c0 the law comes to p′ = 0 at a finite strain

/// x^y with the sign of x; 0 at 0.
double signed_power(double x, double y) {
  return std::copysign(std::exp(y * std::log(std::abs(x))), x);
}

/// x^y, at the price of a product for the exponents that most sands have.
double cheap_power(double x, double y) {
  if (y == 2) return x * x;
  if (y == 1) return x;
  return std::exp(y * std::log(x));
}

/// F, of t* with its squared norm.
template <class Space>
double lode_factor(const Vector<Space>& t, double squared_norm) {
  if constexpr (Space::kSize == 2) {
    // tan ψ = √2 |t₁ − t₃|; in extension tan ψ/√2 = t₃ − t₁.
    const double difference = t(0) - t(1) / sqrt2;
    return difference >= 0 ? 1 : 1 + difference;
  } else {
    constexpr double kNothing = 1e-24;
    if (squared_norm < kNothing) return 1;
    const double tangent = std::sqrt(3 * squared_norm);
    const double tangent_cosine = -3 * sqrt2 * square<Space>(t).dot(t) / squared_norm;
    return std::sqrt(3 * squared_norm / 8 + (2 - 3 * squared_norm) / (2 + sqrt2 * tangent_cosine)) -
           tangent / (2 * sqrt2);
  }
}

}  // namespace

const ParameterTable<HypoplasticParameters>& hypoplastic_table() {
  using P = HypoplasticParameters;
  static const ParameterTable<P> table = {
      {{"critical_friction_angle_deg",
        "φ_c",
        "deg",
        "friction angle at critical state",
        {.above = 0, .below = 90}},
       &P::critical_friction_angle},
      {{"granulate_hardness_kPa", "h_s", "kPa", "hardness of the granulate", {.above = 0}},
       &P::granulate_hardness_pa},
      {{"pressure_exponent", "n", "", "fall of the void ratios with p'", {.above = 0, .below = 1}},
       &P::pressure_exponent},
      {{"densest_void_ratio", "e_d0", "", "smallest void ratio at p' = 0", {.above = 0}},
       &P::densest_void_ratio},
      {{"critical_void_ratio", "e_c0", "", "critical void ratio at p' = 0", {.above = 0}},
       &P::critical_void_ratio},
      {{"loosest_void_ratio", "e_i0", "", "largest void ratio at p' = 0", {.above = 0}},
       &P::loosest_void_ratio},
      {{"peak_exponent", "α", "", "peak friction with density", {.at_least = 0}},
       &P::peak_exponent},
      {{"stiffness_exponent", "β", "", "stiffness with density", {.at_least = 0}},
       &P::stiffness_exponent},
      {{"intergranular_range",
        "R",
        "",
        "largest intergranular strain; 0: the law without it",
        {.at_least = 0, .below = 0.1},
        ParameterKind::number,
        0},
       &P::intergranular_range},
      {{"reversal_factor",
        "m_R",
        "",
        "stiffness after a reversal, over that of the base law",
        {.at_least = 1},
        ParameterKind::number,
        5},
       &P::reversal_factor},
      {{"transverse_factor",
        "m_T",
        "",
        "ratio of the stiffness after a change of direction by 90 degrees",
        {.at_least = 1},
        ParameterKind::number,
        2},
       &P::transverse_factor},
      {{"intergranular_rate_exponent",
        "β_r",
        "",
        "approach of the intergranular strain to its range",
        {.above = 0},
        ParameterKind::number,
        0.5},
       &P::intergranular_rate_exponent},
      {{"intergranular_exponent",
        "χ",
        "",
        "fall of the stiffness with the intergranular strain",
        {.at_least = 1},
        ParameterKind::number,
        6},
       &P::intergranular_exponent},
      {{"intergranular_start",
        "ρ_0",
        "",
        "isotropic fraction of R after consolidation",
        {.at_least = 0, .at_most = 1},
        ParameterKind::number,
        1},
       &P::intergranular_start}};
  return table;
}

LawDescription hypoplastic_law() {
  return describe<Hypoplastic>(
      "hypoplastic", "Hypoplasticity of von Wolffersdorff, with intergranular strain if R > 0",
      "von Wolffersdorff (1996), Mech. Cohes.-Frict. Mater. 1:251; Niemunis and Herle (1997), "
      "Mech. Cohes.-Frict. Mater. 2:279",
      hypoplastic_table());
}

template <class Space>
Hypoplastic<Space>::Hypoplastic(const HypoplasticParameters& p) : parameters_(p) {
  check_parameters(p, hypoplastic_table());
  const double e_d = p.densest_void_ratio, e_c = p.critical_void_ratio, e_i = p.loosest_void_ratio;
  if (e_c <= e_d)
    throw std::invalid_argument("critical_void_ratio is " + short_number(e_c) +
                                ", must be above densest_void_ratio = " + short_number(e_d));
  if (e_i < e_c)
    throw std::invalid_argument("loosest_void_ratio is " + short_number(e_i) +
                                ", must be at least critical_void_ratio = " + short_number(e_c));
  const double sine = std::sin(p.critical_friction_angle);
  a_ = kRoot3 * (3 - sine) / (2 * sqrt2 * sine);
  critical_ratio_ = stress_ratio_at_friction_angle(p.critical_friction_angle);
  const double rest =
      3 + a_ * a_ - a_ * kRoot3 * std::pow((e_i - e_d) / (e_c - e_d), p.peak_exponent);
  if (rest <= 0)
    throw std::invalid_argument("peak_exponent is " + short_number(p.peak_exponent) +
                                ", too large with these void ratios and this friction angle: the "
                                "stiffness in isotropic compression would not be positive");
  barotropy_ = p.granulate_hardness_pa / p.pressure_exponent *
               std::pow(e_i / e_c, p.stiffness_exponent) / rest;
  log_hardness_ = std::log(p.granulate_hardness_pa);
}

template <class Space>
PointState<Space> Hypoplastic<Space>::start(const Vector<Space>& stress, double void_ratio) const {
  State state{stress, void_ratio, {}};
  if (has_intergranular_strain())
    state.memory = parameters_.intergranular_start * parameters_.intergranular_range / kRoot3 *
                   identity<Space>();
  return state;
}

template <class Space>
std::vector<std::string> Hypoplastic<Space>::memory_names() const {
  if (!has_intergranular_strain()) return {};
  std::vector<std::string> names;
  name_components<Space>("intergranular", names);
  return names;
}

template <class Space>
std::optional<std::string> Hypoplastic<Space>::objection(const State& state) const {
  if (auto general = Law<Space>::objection(state)) return general;
  if (state.p() < kLiquefied)
    return "p' is below " + short_number(kLiquefied / 1e3) +
           " kPa: liquefied, and the law's stiffness vanishes with p'";
  if (!all_compressed<Space>(state.stress))
    return "a principal effective stress is not above 0, where the law ends";
  return std::nullopt;
}

template <class Space>
std::optional<std::string> Hypoplastic<Space>::warning(const State& state) const {
  const double fallen = compression(state.p());
  const double e_i = parameters_.loosest_void_ratio * fallen;
  const double e_d = parameters_.densest_void_ratio * fallen;
  if (state.void_ratio > e_i)
    return "the void ratio is " + short_number(state.void_ratio) +
           ", above e_i = " + short_number(e_i) +
           ": a metastable fabric outside the calibrated range";
  if (state.void_ratio < e_d)
    return "the void ratio is " + short_number(state.void_ratio) +
           ", below e_d = " + short_number(e_d) + ": denser than the calibrated range";
  return std::nullopt;
}

template <class Space>
double Hypoplastic<Space>::compression(double p) const {
  return std::exp(
      -std::pow(3 * p / parameters_.granulate_hardness_pa, parameters_.pressure_exponent));
}

template <class Space>
double Hypoplastic<Space>::density_factor(const State& state) const {
  const double fallen = compression(state.p());
  const double e_d = parameters_.densest_void_ratio * fallen;
  const double e_c = parameters_.critical_void_ratio * fallen;
  return signed_power((state.void_ratio - e_d) / (e_c - e_d), parameters_.peak_exponent);
}

template <class Space>
std::optional<double> Hypoplastic<Space>::instability_stress_ratio(const State& state) const {
  const double f_d = density_factor(state);
  if (f_d < 1) return std::nullopt;
  return critical_ratio_ * (f_d - std::sqrt(f_d * f_d - 1));
}

template <class Space>
void Hypoplastic<Space>::linear_and_norm(const State& state, Matrix<Space>& linear,
                                         Vector<Space>& norm) const {
  const auto& par = parameters_;
  const double tr = trace<Space>(state.stress);
  const double e = state.void_ratio;
  // Two or three logarithms and three or four exponentials are all that one response costs.
  const double power = std::exp(par.pressure_exponent * (std::log(tr) - log_hardness_));
  const double fallen = std::exp(-power);
  const double f_e = cheap_power(par.critical_void_ratio * fallen / e, par.stiffness_exponent);
  const double e_d = par.densest_void_ratio * fallen;
  const double f_d =
      signed_power((e - e_d) / (par.critical_void_ratio * fallen - e_d), par.peak_exponent);
  const double f_b = barotropy_ * (1 + 1 / (par.loosest_void_ratio * fallen)) * tr /
                     (par.granulate_hardness_pa * power);

  const Vector<Space> t = state.stress / tr;
  const Vector<Space> t_star = deviator<Space>(t);
  const double squared = t_star.squaredNorm();
  const double f = lode_factor<Space>(t_star, squared);
  const double scale = f_b * f_e / (squared + 1.0 / 3);
  linear.noalias() = (scale * a_ * a_ * t) * t.transpose();
  linear.diagonal().array() += scale * f * f;
  norm = (scale * f_d * a_ * f) * (t + t_star);
}

template <class Space>
void Hypoplastic<Space>::response(const State& state, Response<Space>& out) const {
  StiffnessForm<Space>& form = stiffness_form(out);
  linear_and_norm(state, form.stiffness, form.norm_term);
  if (has_intergranular_strain())
    add_intergranular(state, form);
  else
    form.nonlinear = true;
}

template <class Space>
void Hypoplastic<Space>::add_intergranular(const State& state, StiffnessForm<Space>& form) const {
  const auto& par = parameters_;
  Vector<Space> direction = state.memory.template head<kSize>();
  const double size = direction.norm();
  const double rho = std::min(1.0, size / par.intergranular_range);
  double share = 0, relaxation = 0;  // ρ^χ, ρ^β_r
  if (size > 0) {
    direction /= size;
    const double log_rho = std::log(rho);
    share = std::exp(par.intergranular_exponent * log_rho);
    relaxation = std::exp(par.intergranular_rate_exponent * log_rho);
  }
  const Vector<Space> along = form.stiffness * direction;
  form.stiffness *= share * par.transverse_factor + (1 - share) * par.reversal_factor;
  form.stiffness.noalias() +=
      (share * (par.reversal_factor - par.transverse_factor) * along) * direction.transpose();
  form.add_switch(share * ((par.reversal_factor - 1) * along + form.norm_term), direction);
  form.memory_slope[0] = -relaxation * direction;
}

template <class Space>
void Hypoplastic<Space>::memory_rate(const State&, const Response<Space>& response,
                                     const PointRate<Space>& rate, Memory& out) const {
  if (!has_intergranular_strain()) return;
  const auto& form = std::get<StiffnessForm<Space>>(response);
  out = rate.strain + rate.multiplier[0] * form.memory_slope[0].template head<kSize>();
}

template <class Space>
void Hypoplastic<Space>::settle(State& state, unsigned) const {
  const double size = state.memory.norm();
  if (has_intergranular_strain() && size > parameters_.intergranular_range)
    state.memory *= parameters_.intergranular_range / size;
}

template class Hypoplastic<Axisymmetric>;
template class Hypoplastic<Tensor>;

}  // namespace triax::sim
