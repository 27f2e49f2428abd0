// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/stress_span.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {
namespace {

constexpr double kEtaLeast = -1.5, kEtaMost = 3;  ///< at σ₁′ = 0 and σ₃′ = 0

double stress_ratio(double q, double p_eff) {
  return p_eff > 0 ? std::clamp(q / p_eff, kEtaLeast, kEtaMost) : std::copysign(kEtaMost, q);
}

void widen(Interval& interval, double value) {
  interval.low = std::min(interval.low, value);
  interval.high = std::max(interval.high, value);
}

Interval beside(double value, const Interval& reached, double error) {
  const double noise = StressSpan::kOf95 * error;
  return {value - std::hypot(value - reached.low, noise),
          value + std::hypot(reached.high - value, noise)};
}

}  // namespace

StressError error_of_readings(double stress_variance, double q, double p_eff) {
  StressError error;
  error.q = std::sqrt(1.5 * stress_variance);
  error.p_eff = std::sqrt(stress_variance / 3);
  error.eta = std::hypot(error.q, stress_ratio(q, p_eff) * error.p_eff) / std::fabs(p_eff);
  return error;
}

StressSpan::StressSpan(double q, double p_eff) : q_(q), p_(p_eff), eta_(stress_ratio(q, p_eff)) {
  reached_ = {{q_, q_}, {p_, p_}, {eta_, eta_}};
}

void StressSpan::reach(double q, double p_eff) {
  if (!std::isfinite(q) || !std::isfinite(p_eff)) return;
  widen(reached_.q_pa, q);
  widen(reached_.p_eff_pa, p_eff);
  widen(reached_.eta, stress_ratio(q, p_eff));
}

void StressSpan::reach_q(double q) {
  if (std::isfinite(q)) widen(reached_.q_pa, q);
}

StressInterval StressSpan::interval(const StressError& error) const {
  return {beside(q_, reached_.q_pa, error.q), beside(p_, reached_.p_eff_pa, error.p_eff),
          beside(eta_, reached_.eta, error.eta)};
}

StressInterval as_interval(double q, double p_eff) { return StressSpan(q, p_eff).interval({}); }

StressInterval hull(const StressInterval& a, const StressInterval& b) {
  const auto both = [](const Interval& one, const Interval& other) {
    return Interval{std::min(one.low, other.low), std::max(one.high, other.high)};
  };
  return {both(a.q_pa, b.q_pa), both(a.p_eff_pa, b.p_eff_pa), both(a.eta, b.eta)};
}

}  // namespace triax::lab
