#include "sim/materials/sanisand.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace triax::sim {
namespace {

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

void require(bool ok, const char* name, double found, const char* wanted) {
  if (!ok || !std::isfinite(found))
    throw std::invalid_argument(std::string(name) + " is " + number(found) + ", must be " + wanted);
}

}  // namespace

Sanisand::Sanisand(const SanisandParameters& p) : parameters_(p) {
  require(p.shear_modulus_factor > 0, "shear_modulus_factor", p.shear_modulus_factor, "above 0");
  require(p.poisson_ratio > -1 && p.poisson_ratio < 0.5, "poisson_ratio", p.poisson_ratio,
          "between -1 and 0.5");
  require(p.critical_stress_ratio > 0 && p.critical_stress_ratio < 3, "critical_stress_ratio",
          p.critical_stress_ratio, "between 0 and 3");
  require(p.extension_ratio > 0 && p.extension_ratio <= 1, "extension_ratio", p.extension_ratio,
          "above 0 and at most 1");
  require(p.critical_void_ratio > 0, "critical_void_ratio", p.critical_void_ratio, "above 0");
  require(p.critical_slope >= 0, "critical_slope", p.critical_slope, "0 or more");
  require(p.critical_exponent > 0, "critical_exponent", p.critical_exponent, "above 0");
  require(p.yield_radius > 0 && p.yield_radius < 0.2, "yield_radius", p.yield_radius,
          "between 0 and 0.2");
  require(p.hardening_factor > 0, "hardening_factor", p.hardening_factor, "above 0");
  require(p.hardening_void_ratio_factor >= 0, "hardening_void_ratio_factor",
          p.hardening_void_ratio_factor, "0 or more");
  require(p.bounding_exponent >= 0, "bounding_exponent", p.bounding_exponent, "0 or more");
  require(p.dilatancy_factor >= 0, "dilatancy_factor", p.dilatancy_factor, "0 or more");
  require(p.dilatancy_exponent >= 0, "dilatancy_exponent", p.dilatancy_exponent, "0 or more");
  require(p.fabric_limit >= 0, "fabric_limit", p.fabric_limit, "0 or more");
  require(p.fabric_rate >= 0, "fabric_rate", p.fabric_rate, "0 or more");
  require(p.atmospheric_pressure_pa > 0, "atmospheric_pressure", p.atmospheric_pressure_pa,
          "above 0");
}

SanisandState Sanisand::isotropic(double p_pa, double void_ratio) {
  State state;
  state.p = p_pa;
  state.void_ratio = void_ratio;
  return state;
}

std::optional<std::string> Sanisand::objection(const State& state) const {
  if (!std::isfinite(state.p + state.q + state.void_ratio + state.alpha + state.fabric))
    return "the state is not finite";
  if (state.p <= 0) return "p' is " + number(state.p / 1e3) + " kPa, must be above 0";
  if (state.void_ratio <= 0)
    return "the void ratio is " + number(state.void_ratio) + ", must be above 0";
  if (state.void_ratio >= 2.97)
    return "the void ratio is " + number(state.void_ratio) + ", must be below 2.97";
  const double c_h = parameters_.hardening_void_ratio_factor;
  if (1 - c_h * state.void_ratio <= 0)
    return "the void ratio is " + number(state.void_ratio) +
           ", must be below 1/c_h = " + number(1 / c_h) +
           ", where this parameter set's hardening vanishes";
  return std::nullopt;
}

double Sanisand::shear_modulus(const State& state) const {
  const double gap = 2.97 - state.void_ratio;
  return parameters_.shear_modulus_factor * gap * gap / (1 + state.void_ratio) *
         std::sqrt(state.p * parameters_.atmospheric_pressure_pa);
}

double Sanisand::bulk_modulus(const State& state) const {
  const double nu = parameters_.poisson_ratio;
  return 2 * (1 + nu) / (3 * (1 - 2 * nu)) * shear_modulus(state);
}

double Sanisand::state_parameter(const State& state) const {
  const double ratio = state.p / parameters_.atmospheric_pressure_pa;
  return state.void_ratio - parameters_.critical_void_ratio +
         parameters_.critical_slope * std::pow(ratio, parameters_.critical_exponent);
}

double Sanisand::yield_distance(const State& state) const {
  return std::abs(state.q / state.p - state.alpha) - parameters_.yield_radius;
}

bool Sanisand::on_yield(const State& state) const {
  return yield_distance(state) >= -1e-9 * parameters_.yield_radius;
}

SanisandState Sanisand::at_yield(State state) const {
  const double s = side(state);
  state.alpha = state.q / state.p - s * parameters_.yield_radius;
  if (s * (state.alpha - state.alpha_in) < 0) state.alpha_in = state.alpha;
  return state;
}

double Sanisand::contraction_fade(double p) const {
  const double x = p / (0.02 * parameters_.atmospheric_pressure_pa);
  return x < 1 ? x * x * (3 - 2 * x) : 1;
}

ElastoplasticTangent Sanisand::tangent(const State& state) const {
  const auto& par = parameters_;
  const double s = side(state);
  const double eta = state.q / state.p;
  const double psi = state_parameter(state);
  const double limit = par.critical_stress_ratio * (s > 0 ? 1 : par.extension_ratio);
  const double bounding = limit * std::exp(-par.bounding_exponent * psi);
  const double dilatancy_line = limit * std::exp(par.dilatancy_exponent * psi);
  double dilatancy =
      par.dilatancy_factor * (1 + std::max(0.0, s * state.fabric)) * (dilatancy_line - s * eta);
  if (dilatancy > 0) dilatancy *= contraction_fade(state.p);

  const double shear = shear_modulus(state);
  const double nu = par.poisson_ratio;
  ElastoplasticTangent t;
  t.elastic << 2 * (1 + nu) / (3 * (1 - 2 * nu)) * shear, 0, 0, 3 * shear;
  // H is multiplied by the distance since the last reversal, and r with it: both stay finite.
  const double distance = std::abs(state.alpha - state.alpha_in);
  t.flow << distance * dilatancy, distance * s;
  t.normal << -s * eta, s;
  t.hardening = state.p * par.shear_modulus_factor * par.hardening_factor *
                (1 - par.hardening_void_ratio_factor * state.void_ratio) /
                std::sqrt(state.p / par.atmospheric_pressure_pa) * (bounding - s * eta);
  return t;
}

SanisandRate Sanisand::rate(const State& state, const Eigen::Vector2d& stress,
                            const Eigen::Vector2d& strain,
                            const Eigen::Vector2d& plastic_strain) const {
  Rate r;
  r.stress = stress;
  r.void_ratio = -(1 + state.void_ratio) * strain(0);
  r.fabric = -parameters_.fabric_rate * std::max(0.0, -plastic_strain(0)) *
             (side(state) * parameters_.fabric_limit + state.fabric);
  return r;
}

SanisandState Sanisand::moved(State from, const Rate& rate, bool plastic) const {
  const double s = side(from);
  from.p += rate.stress(0);
  from.q += rate.stress(1);
  from.void_ratio += rate.void_ratio;
  from.fabric += rate.fabric;
  if (plastic) from.alpha = from.q / from.p - s * parameters_.yield_radius;
  return from;
}

double Sanisand::error_measure(const Rate& error, const State& at) const {
  const double scale = at.p + 1e-6 * parameters_.atmospheric_pressure_pa;
  return std::max({error.stress.cwiseAbs().maxCoeff() / scale, std::abs(error.void_ratio),
                   std::abs(error.fabric) / (1 + parameters_.fabric_limit)});
}

}  // namespace triax::sim
