// SPDX-License-Identifier: GPL-3.0-or-later
// What goes by the peak: friction, dilatancy, strength.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/study/soil/soil_fits.hpp"

namespace triax::study {
namespace {

/// Of repeated tests: half a degree of friction, a twentieth of an undrained strength.
constexpr double kUsualEta = 0.02, kUsualDilatancy = 0.02, kUsualRatio = 0.05;
/// Of q_peak/(2 p′₀) over ψ₀, in triax's laws.
constexpr UsualCurve kStrengthCurve{.of_state = 4, .of_pressure = 0.04};
/// Of σ₁′, and by how much it grows with the range of void ratios: a set is meant to have one.
constexpr double kUsualStrength = 0.02, kByVoidRatio = 1.5, kOneDensity = 0.1;
/// Fall of η after its peak that makes it one: of a level curve any point may be the largest.
constexpr double kPassed = 0.01;

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

/// Whether that value of the path's points fell by kPassed after it was largest.
template <class Value>
bool passed(const TestPoints& test, const TestPoint& peak, const Value& value) {
  double least = value(peak);
  for (const auto& p : test.path)
    if (p.axial_strain > peak.axial_strain) least = std::min(least, value(p));
  return least <= (1 - kPassed) * value(peak);
}
bool passed_eta(const TestPoints& test) {
  return passed(test, *test.peak_eta, [](const TestPoint& p) { return p.eta(); });
}
bool passed_q(const TestPoints& test) {
  return test.peak_q && passed(test, *test.peak_q, [](const TestPoint& p) { return p.q_kPa; });
}

/// Of one whose q fell after its peak: the end of a test is no strength.
std::optional<Estimate> strength_of(const TestPoints& test) {
  if (test.drained || !test.strength_ratio || !passed_q(test)) return std::nullopt;
  return measured(*test.strength_ratio, 0.005 * *test.strength_ratio);
}

/// A level curve has its dilatancy anywhere: it judges no test.
JudgedForm peak_form(const Soil& soil, const Gathered& all, const FitWords& words) {
  JudgedForm form = judged_form(all, FitKind::line, words);
  for (std::size_t i = 0; i < all.tests.size(); ++i)
    form.points[i].judged = passed_eta(soil.tests[all.tests[i]]);
  return form;
}

}  // namespace

void fit_peaks(Soil& soil, const SoilOptions& options) {
  // Peaks depend on density: the scatter of their mean is that of the sand, and none is odd.
  if (const auto angles = peak_angles(soil); angles.points.size() > 1)
    soil.peak_angle_deg = Level{*fit_mean(angles.points), angles.tests};
  const Gathered peaks = stress_over_dilatancy(soil);
  const FitWords words{"stress-dilatancy at the peak", "η at the peak", kUsualEta};
  JudgedForm form = peak_form(soil, peaks, words);
  add_cohesion(form, soil, peaks, [](const TestPoints& t) { return t.peak_eta->p_eff_kPa; });
  soil.stress_dilatancy = trend_of(soil, options, peaks, Forms{form}, words, false);
  const Gathered dilatancies = over_state(soil, [](const auto& t) { return t.dilatancy_at_peak; });
  const FitWords of_dilatancy{"dilatancy over ψ", "dε_v/dε_q at the peak", kUsualDilatancy, 0,
                              kUsualPsi};
  soil.dilatancy_over_state =
      trend_of(soil, options, dilatancies, Forms{peak_form(soil, dilatancies, of_dilatancy)},
               of_dilatancy, false);
  const Gathered strengths = over_state(soil, strength_of);
  const FitWords of_strength{"undrained strength over ψ", "q_peak/(2 p′₀)", 0, kUsualRatio,
                             kUsualPsi};
  soil.strength_over_state = trend_of(
      soil, options, strengths,
      Forms{form_over_state(soil, strengths, of_strength, kStrengthCurve)}, of_strength, false);
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
  const bool one_drainage = std::ranges::all_of(circles, [&](const auto& c) {
    return soil.tests[c.test].drained == soil.tests[circles.front().test].drained;
  });
  Gathered left = all;
  // Specimens of several densities, or of both drainages, are on no one line.
  if (range <= kOneDensity && one_drainage) {
    const double by_density = kByVoidRatio * range / std::sqrt(12.0);  // spread evenly
    for (auto& point : all.points) point.y_error = 0;  // what specimens scatter is in the words
    left = without_odd(
        soil, options, all, FitKind::line,
        {"c′ and φ′", "σ₁′ at failure (kPa)", 0, std::hypot(kUsualStrength, by_density)});
  }
  std::erase_if(circles, [&](const auto& c) {
    return std::ranges::find(left.tests, c.test) == left.tests.end();
  });
  const std::size_t count = circles.size();
  soil.strength = strength_set(std::move(circles), options.criterion);
  if (soil.strength && range > kOneDensity)
    soil.notes.push_back(
        fmt::format("c′ and φ′ are from specimens of e = {:.3f} to {:.3f} together, but strength "
                    "depends on density: choose tests of one density with --where",
                    *soil.densest, *soil.loosest));
  if (!soil.strength && count > 0)
    soil.notes.push_back(fmt::format(
        "c′ and φ′ need three specimens that failed at different σ₃′; found {}", count));
}

}  // namespace triax::study
