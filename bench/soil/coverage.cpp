// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/soil/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace triax::bench {
namespace {

using study::Estimate;

void add(std::vector<Covered>& all, const std::string& what, const Estimate& estimate,
         std::optional<double> truth) {
  if (!truth) return;
  all.push_back(
      {what, estimate.holds(*truth), estimate.value - *truth, (estimate.high - estimate.low) / 2});
}

void add_line(std::vector<Covered>& all, const Campaign& c, const study::Soil& soil) {
  if (!soil.critical_line || !c.truth.critical_void_ratio) return;
  const auto& line = soil.critical_line->line;
  if (c.truth.gamma) {
    add(all, "Gamma", line.intercept(), c.truth.gamma);
    const Estimate slope = line.slope();
    add(all, "lambda", {-slope.value, slope.error, -slope.high, -slope.low, slope.tests},
        c.truth.lambda);
    const double middle = (line.x_low + line.x_high) / 2;
    add(all, "e_c in the middle, log-linear", line.line_at(middle),
        c.truth.critical_void_ratio(std::exp(middle)));
  }
  const auto& power = *soil.critical_power;
  if (!c.truth.e0 || power.exponent_held) return;
  add(all, "e_0, power form", power.void_ratio, c.truth.e0);
  add(all, "lambda, power form", power.slope, c.truth.slope);
  add(all, "xi, power form", power.exponent, c.truth.exponent);
}

void add_onset(std::vector<Covered>& all, const Campaign& c, const study::Soil& soil) {
  for (const auto& of : soil.onsets) {
    if (of.kind != lab::CollapseKind::flow || of.extension || !of.over_state) continue;
    const auto& trend = *of.over_state;
    double psi = 0, log_p = 0;
    for (std::size_t i = 0; i < trend.tests.size(); ++i) {
      psi += trend.points[i].x / static_cast<double>(trend.tests.size());
      log_p +=
          std::log(*soil.tests[trend.tests[i]].p_eff_kPa) / static_cast<double>(trend.tests.size());
    }
    add(all, "eta at onset at the mean psi", trend.line.line_at(psi),
        c.truth.onset(psi, std::exp(log_p)));
  }
}

}  // namespace

std::vector<Covered> covered(const Campaign& c, const study::Soil& soil) {
  std::vector<Covered> all;
  add_line(all, c, soil);
  if (soil.critical_ratio) {
    add(all, "M", soil.critical_ratio->fit.mean, c.truth.m);
    if (c.truth.m)
      add(all, "phi_c (deg)", friction_angle(soil.critical_ratio->fit.mean, false),
          friction_angle(study::measured(*c.truth.m, 0), false).value);
  }
  if (soil.extension_ratio) add(all, "M_e", soil.extension_ratio->fit.mean, c.truth.m_extension);
  if (soil.extension_share && c.truth.m_extension)
    add(all, "M_e/M", *soil.extension_share, *c.truth.m_extension / *c.truth.m);
  if (soil.strength) {
    add(all, "c' (kPa)", soil.strength->cohesion_kPa, c.truth.cohesion_kPa);
    add(all, "phi' (deg)", soil.strength->friction_angle_deg, c.truth.friction_angle_deg);
  }
  add_onset(all, c, soil);
  return all;
}

void Count::add(const Covered& one) {
  ++all;
  held += one.held;
  squares += one.error * one.error;
  half_widths.push_back(one.half_width);
}

bool names(const study::Soil& soil, const std::string& test) {
  return std::ranges::any_of(
      soil.tests, [&](const auto& t) { return t.used && t.name == test && !t.reason.empty(); });
}

}  // namespace triax::bench
