// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/soil/soil_values.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/output/words.hpp"

namespace triax::src {
namespace {

using study::Estimate;

Estimate turned(const Estimate& e) { return {-e.value, e.error, -e.high, -e.low, e.tests}; }

void add_critical(const study::Soil& soil, std::vector<SoilValue>& values) {
  if (!soil.critical_line) return;
  const auto& line = soil.critical_line->line;
  values.push_back({"Γ, e = Γ − λ ln(p′/1 kPa)", line.intercept()});
  values.push_back({"λ", turned(line.slope()), 4});
  const auto& power = *soil.critical_power;
  values.push_back({"e₀, e = e₀ − λ_p (p′/100 kPa)^ξ", power.void_ratio});
  values.push_back({"λ_p", power.slope, 4});
  values.push_back({"ξ", power.exponent, 2});
}

void add_friction(const study::Soil& soil, std::vector<SoilValue>& values) {
  if (soil.critical_ratio) {
    values.push_back({"M, compression", soil.critical_ratio->fit.mean});
    values.push_back({"φ critical, compression (°)",
                      study::friction_angle(soil.critical_ratio->fit.mean, false), 1});
  }
  if (soil.extension_ratio) {
    values.push_back({"M_e, extension", soil.extension_ratio->fit.mean});
    values.push_back({"φ critical, extension (°)",
                      study::friction_angle(soil.extension_ratio->fit.mean, true), 1});
  }
  if (soil.extension_share) values.push_back({"M_e/M", *soil.extension_share});
  if (soil.peak_angle_deg)
    values.push_back({"φ peak of dilating tests, mean (°)", soil.peak_angle_deg->fit.mean, 1});
}

void add_dilatancy(const study::Soil& soil, std::vector<SoilValue>& values) {
  if (soil.stress_dilatancy) {
    const auto& line = soil.stress_dilatancy->line;
    values.push_back({"η peak without dilatancy", line.intercept()});
    values.push_back({"its growth with −dε_v/dε_q (1 − N)", line.slope(), 2});
  }
  if (soil.dilatancy_over_state)
    values.push_back(
        {"χ, dε_v/dε_q at the peak over ψ₀", soil.dilatancy_over_state->line.slope(), 2});
}

void add_strength(const study::Soil& soil, std::vector<SoilValue>& values) {
  if (!soil.strength) return;
  const auto& set = *soil.strength;
  const std::string at = " at " + spaced(std::string(to_string(set.criterion)));
  values.push_back({"c′ (kPa)" + at, set.cohesion_kPa, 1});
  values.push_back({"φ′ (°)" + at, set.friction_angle_deg, 1});
  if (set.friction_angle_without_cohesion_deg)
    values.push_back({"φ′ (°) with c′ = 0", *set.friction_angle_without_cohesion_deg, 1});
}

void add_onsets(const study::Soil& soil, std::vector<SoilValue>& values) {
  for (const auto& of : soil.onsets) {
    if (!of.over_state) continue;
    const std::string what = fmt::format("η at onset, {}, {}", lab::to_string(of.kind),
                                         of.extension ? "extension" : "compression");
    values.push_back({what + ": at ψ₀ = 0", of.over_state->line.intercept()});
    values.push_back({what + ": slope over ψ₀", of.over_state->line.slope(), 2});
  }
  if (soil.strength_over_state) {
    const auto& line = soil.strength_over_state->line;
    values.push_back({"undrained q_peak/(2 p′₀): at ψ₀ = 0", line.intercept()});
    values.push_back({"undrained q_peak/(2 p′₀): slope over ψ₀", line.slope(), 2});
  }
}

void add_cyclic(const study::Soil& soil, std::vector<SoilValue>& values) {
  for (const auto& of : soil.cyclic) {
    const Estimate log_csr = of.trend.line.line_at(std::log(15.0));
    values.push_back({"CSR for 15 cycles to " + spaced(of.criterion),
                      {std::exp(log_csr.value), std::exp(log_csr.value) * log_csr.error,
                       std::exp(log_csr.low), std::exp(log_csr.high), log_csr.tests}});
    values.push_back({"b, CSR = a N^−b", turned(of.trend.line.slope())});
  }
}

}  // namespace

std::vector<SoilValue> soil_values(const study::Soil& soil) {
  std::vector<SoilValue> values;
  add_critical(soil, values);
  add_friction(soil, values);
  add_dilatancy(soil, values);
  add_strength(soil, values);
  add_onsets(soil, values);
  add_cyclic(soil, values);
  return values;
}

}  // namespace triax::src
