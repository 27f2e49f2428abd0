// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/soil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/base/bad_input.hpp"
#include "src/study/soil/soil_fits.hpp"
#include "src/study/soil/twice.hpp"

namespace triax::study {
namespace {

void set_limits(Soil& soil) {
  for (const auto& test : soil.tests) {
    if (!test.used || !test.void_ratio) continue;
    soil.densest = std::min(soil.densest.value_or(*test.void_ratio), *test.void_ratio);
    soil.loosest = std::max(soil.loosest.value_or(*test.void_ratio), *test.void_ratio);
  }
}

void note_missing_void_ratios(Soil& soil) {
  std::string names;
  int count = 0;
  for (const auto& test : soil.tests)
    if (test.used && !test.void_ratio) names += (count++ > 0 ? ", " : "") + test.name;
  if (count > 0)
    soil.notes.push_back(fmt::format(
        "the void ratio of {} is unknown: {} not used for the critical state line and trends over "
        "ψ; give it with `triax replay --set specimen.consolidated_void_ratio=...`",
        names, count == 1 ? "it is" : "they are"));
}

void set_state_parameters(Soil& soil) {
  if (!soil.critical_line) return;
  for (auto& test : soil.tests) {
    if (!test.used || !test.void_ratio || !test.p_eff_kPa) continue;
    const Estimate e = soil.critical_void_ratio(*test.p_eff_kPa);
    const double degrees =
        (soil.power_is_better ? soil.critical_power->line : soil.critical_line->line).degrees();
    test.state_parameter = estimate(*test.void_ratio - e.value, e.error, degrees, e.tests);
  }
}

}  // namespace

Estimate Soil::critical_void_ratio(double p_eff_kPa) const {
  if (!power_is_better) return critical_line->line.line_at(std::log(p_eff_kPa));
  return critical_power->line.line_at(
      -std::pow(p_eff_kPa / kPowerPressure_kPa, critical_power->exponent.value));
}

double CyclicResistance::at_cycles(double n) const { return std::exp(trend.line.at(std::log(n))); }

Soil study_soil(const std::vector<ShearedTest>& tests, const std::string& group,
                const SoilOptions& options) {
  Soil soil;
  soil.group = group;
  for (const auto& test : tests) soil.tests.push_back(test_points(test, options.stress_error_kPa));
  leave_out_twice(tests, soil.tests);
  if (std::ranges::none_of(soil.tests, &TestPoints::used))
    throw lab::BadInput(
        fmt::format("{}none of {} test{} has a shear stage with known stresses and strains; `triax "
                    "query tests` lists all tests",
                    group.empty() ? "" : group + ": ", tests.size(), tests.size() == 1 ? "" : "s"));
  set_limits(soil);
  note_missing_void_ratios(soil);
  fit_critical_states(soil, options);
  set_state_parameters(soil);
  fit_peaks(soil, options);
  fit_strength(soil, options);
  fit_onsets(soil, options);
  fit_cyclic(soil, options);
  return soil;
}

}  // namespace triax::study
