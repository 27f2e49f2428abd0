// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/total_uncertainty.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace triax::lab {
namespace {

constexpr double kOf95 = 1.96;

/// What one source does to q, p′ and η, one standard uncertainty of it.
struct Effect {
  const char* name;
  double q = 0, p_eff = 0;
};

double on_eta(const Effect& effect, double eta, double p_eff) {
  return (effect.q - eta * effect.p_eff) / p_eff;
}

Interval widened(const Interval& own, double value, double variance) {
  const double square = kOf95 * kOf95 * variance;
  return {value - std::sqrt((value - own.low) * (value - own.low) + square),
          value + std::sqrt((own.high - value) * (own.high - value) + square)};
}

}  // namespace

std::optional<TotalUncertainty> total_uncertainty(const Instant& onset,
                                                  const std::optional<double>& diameter_m,
                                                  const CommonErrors& errors) {
  if (!onset.interval || !onset.eta() || !(*onset.p_eff_pa > 0)) return std::nullopt;
  const double q = *onset.q_pa, p_eff = *onset.p_eff_pa, eta = *onset.eta();
  const double u = onset.pore_pressure_pa.value_or(0), cell = p_eff - q / 3 + u;
  const double rectangular = 1 / std::sqrt(3.0);
  const double of_force = q * errors.force * rectangular;
  const double of_diameter =
      2 * q * errors.diameter_m / diameter_m.value_or(errors.usual_diameter_m) * rectangular;
  const auto of_pressure = [&](double pressure) {
    return (errors.pressure_pa + errors.pressure * std::fabs(pressure)) * rectangular;
  };
  const std::array<Effect, 4> effects{{{"load cell", of_force, of_force / 3},
                                       {"diameter of the specimen", of_diameter, of_diameter / 3},
                                       {"cell pressure transducer", 0, of_pressure(cell)},
                                       {"pore pressure transducer", 0, of_pressure(u)}}};
  double q_variance = 0, p_variance = 0, eta_variance = 0;
  TotalUncertainty total;
  for (const Effect& effect : effects) {
    q_variance += effect.q * effect.q;
    p_variance += effect.p_eff * effect.p_eff;
    const double part = on_eta(effect, eta, p_eff);
    eta_variance += part * part;
    total.budget.push_back({effect.name, part * part});
  }
  const double own = (onset.interval->eta.high - onset.interval->eta.low) / 2 / kOf95;
  total.budget.push_back({"readings and place of the onset", own * own});
  for (UncertaintySource& source : total.budget) source.share /= eta_variance + own * own;
  std::ranges::stable_sort(total.budget, std::greater(), &UncertaintySource::share);
  total.interval = {.q_pa = widened(onset.interval->q_pa, q, q_variance),
                    .p_eff_pa = widened(onset.interval->p_eff_pa, p_eff, p_variance),
                    .eta = widened(onset.interval->eta, eta, eta_variance)};
  return total;
}

}  // namespace triax::lab
