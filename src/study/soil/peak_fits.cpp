// SPDX-License-Identifier: GPL-3.0-or-later
// What goes by the peak: friction, dilatancy, strength.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/study/soil/soil_fits.hpp"

namespace triax::study {
namespace {

constexpr double kUsualEta = 0.03, kUsualDilatancy = 0.06, kUsualRatio = 0.1;
/// Of σ₁′, and by how much it grows with the range of void ratios: a set is meant to have one.
constexpr double kUsualStrength = 0.04, kByVoidRatio = 1.0, kOneDensity = 0.1;

bool in_compression(const TestPoints& test) { return test.used && !test.extension && !test.cyclic; }

Gathered peak_angles(const Soil& soil) {
  Gathered all;
  for (std::size_t i = 0; i < soil.tests.size(); ++i) {
    const auto& test = soil.tests[i];
    if (!in_compression(test) || !test.dilatancy_at_peak || test.dilatancy_at_peak->high > 0)
      continue;
    const auto angle = friction_angle(measured(test.peak_eta->eta(), test.peak_eta_error), false);
    all.add({0, angle.value, 0, angle.error, 0}, i);
  }
  return all;
}

Gathered stress_over_dilatancy(const Soil& soil) {
  Gathered all;
  for (std::size_t i = 0; i < soil.tests.size(); ++i) {
    const auto& test = soil.tests[i];
    if (!in_compression(test) || !test.dilatancy_at_peak) continue;
    all.add({-test.dilatancy_at_peak->value, test.peak_eta->eta(), test.dilatancy_at_peak->error,
             test.peak_eta_error, 0},
            i);
  }
  return all;
}

/// A value over ψ₀.
template <class Value>
Gathered over_state(const Soil& soil, const Value& value) {
  Gathered all;
  for (std::size_t i = 0; i < soil.tests.size(); ++i) {
    const auto& test = soil.tests[i];
    if (!in_compression(test) || !test.state_parameter) continue;
    if (const std::optional<Estimate> y = value(test))
      all.add({test.state_parameter->value, y->value, 0, y->error, 0}, i);
  }
  return all;
}

std::optional<Estimate> strength_of(const TestPoints& test) {
  if (test.drained || !test.strength_ratio) return std::nullopt;
  return measured(*test.strength_ratio, 0.005 * *test.strength_ratio);
}

}  // namespace

void fit_peaks(Soil& soil, const SoilOptions& options) {
  // Peaks depend on density: the scatter of their mean is that of the sand, and none is odd.
  if (const auto angles = peak_angles(soil); angles.points.size() > 1)
    soil.peak_angle_deg = Level{*fit_mean(angles.points), angles.tests};
  soil.stress_dilatancy =
      trend_of(soil, options, stress_over_dilatancy(soil),
               {"stress-dilatancy at the peak", "η at the peak", kUsualEta}, false);
  soil.dilatancy_over_state =
      trend_of(soil, options, over_state(soil, [](const auto& t) { return t.dilatancy_at_peak; }),
               {"dilatancy over ψ", "dε_v/dε_q at the peak", kUsualDilatancy}, false);
  soil.strength_over_state =
      trend_of(soil, options, over_state(soil, strength_of),
               {"undrained strength over ψ", "q_peak/(2 p′₀)", kUsualRatio}, false);
}

void fit_strength(Soil& soil, const SoilOptions& options) {
  std::vector<MohrCircle> circles;
  Gathered all;
  for (std::size_t i = 0; i < soil.tests.size(); ++i) {
    const auto& test = soil.tests[i];
    if (!in_compression(test)) continue;
    const auto failure = failure_of(test, options.criterion, options.failure_strain);
    if (!failure || failure->q_kPa <= 0 || failure->eta() >= 3) continue;
    circles.push_back(circle_of(*failure, false));
    circles.back().test = i;
    circles.back().name = test.name;
    all.add(strength_point(circles.back()), i);
  }
  const double range = soil.loosest.value_or(0) - soil.densest.value_or(0);
  double mean = 0;
  for (const auto& c : circles) mean += c.major_kPa / static_cast<double>(circles.size());
  const Gathered left = without_odd(
      soil, options, all, FitKind::line,
      {"c′ and φ′", "σ₁′ at failure (kPa)", (kUsualStrength + kByVoidRatio * range) * mean});
  std::erase_if(circles, [&](const auto& c) {
    return std::ranges::find(left.tests, c.test) == left.tests.end();
  });
  const std::size_t count = circles.size();
  soil.strength = strength_set(std::move(circles), options.criterion);
  if (soil.strength && range > kOneDensity)
    soil.notes.push_back(
        fmt::format("c′ and φ′ are those of specimens of e = {:.3f} to {:.3f} together, though "
                    "strength goes by "
                    "density: choose a set of one density with --where",
                    *soil.densest, *soil.loosest));
  if (!soil.strength && count > 0)
    soil.notes.push_back(fmt::format(
        "c′ and φ′ need three specimens that failed at different σ₃′, and there are {}", count));
}

}  // namespace triax::study
