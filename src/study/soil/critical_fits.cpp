// SPDX-License-Identifier: GPL-3.0-or-later
// The critical state line, M and M_e.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "src/study/soil/soil_fits.hpp"

namespace triax::study {
namespace {

/// Repeated tests of a good laboratory: 0.01 in e, half a degree of friction.
constexpr double kUsualE = 0.01, kUsualM = 0.02;
/// Specimens of one sand are never more alike than this, however well each is measured: else the
/// one that is measured best would speak for all.
constexpr double kLeastE = 0.006, kLeastM = 0.015;
/// Of the power form, among which the tests may choose where one is judged.
constexpr std::array kExponents = {0.3, 0.5, 0.7, 0.9, 1.1};
/// Of ln p′: beyond that a logarithm of p′ says nothing.
constexpr double kLargestLogError = 0.35;
/// With the valve closed e is prescribed, and what differs between specimens moves p′ at the
/// critical state; what is wrong with the measured e moves e. Nobody knows the shares.
constexpr double kPrescribedE = 0.5;

/// The critical state can be told from no stress at all. Says it where it cannot.
std::vector<bool> with_stress(Soil& soil) {
  std::vector<bool> with;
  for (const auto& test : soil.tests) {
    const auto& c = test.critical;
    const bool any = test.used && c.kind != CriticalKind::none;
    with.push_back(any && c.log_p.error <= kLargestLogError);
    if (any && !with.back())
      soil.notes.push_back(
          fmt::format("{}: p′ at the critical state is {:.1f} kPa, not above its error: not used "
                      "for the critical state line and M",
                      test.name, std::exp(c.log_p.value)));
  }
  return with;
}

Gathered critical_points(const Soil& soil, const std::vector<bool>& with) {
  Gathered all;
  all.least_error = kLeastE;
  for (std::size_t i = 0; i < soil.tests.size(); ++i) {
    const auto& c = soil.tests[i].critical;
    if (!with[i] || !c.void_ratio) continue;
    all.add(
        {c.log_p.value, c.void_ratio->value, c.log_p.error,
         std::hypot(c.void_ratio->error, kLeastE), 0, soil.tests[i].drained ? 0.0 : kPrescribedE},
        i);
  }
  return all;
}

/// e over p′ in the logarithmic form and in some of the power form.
Forms critical_forms(const Soil& soil, const std::vector<bool>& with,
                     std::vector<std::size_t>& tests) {
  Forms forms(1 + kExponents.size(), {.points = {}, .usual_slopes = {kUnknownSlope}});
  for (std::size_t i = 0; i < soil.tests.size(); ++i) {
    const auto& c = soil.tests[i].critical;
    if (!with[i] || !c.void_ratio) continue;
    tests.push_back(i);
    JudgedPoint point{.y = c.void_ratio->value,
                      .y_error = c.void_ratio->error,
                      .x = {c.log_p.value},
                      .x_error = {c.log_p.error},
                      .usual = kUsualE};
    forms.front().points.push_back(point);
    const double p = std::exp(c.log_p.value) / kPowerPressure_kPa, error = p * c.log_p.error;
    for (std::size_t k = 0; k < kExponents.size(); ++k) {
      point.x = {std::pow(p, kExponents[k])};
      point.x_error = {std::pow(p + error, kExponents[k]) - point.x.front()};
      forms[k + 1].points.push_back(point);
    }
  }
  return forms;
}

Gathered critical_ratios(const Soil& soil, const std::vector<bool>& with, bool extension) {
  Gathered all;
  all.least_error = kLeastM;
  for (std::size_t i = 0; i < soil.tests.size(); ++i) {
    const auto& test = soil.tests[i];
    if (with[i] && test.extension == extension)
      all.add({0, test.critical.eta.value, 0, std::hypot(test.critical.eta.error, kLeastM)}, i);
  }
  return all;
}

/// What extrapolation errs by is no scatter: tests of one sand err alike, each by its way.
void add_error_of_ways(const Soil& soil, Level& level) {
  constexpr double kNormal = 1.96;
  double way = 0;
  for (std::size_t i = 0; i < level.tests.size(); ++i)
    way += level.fit.shares[i] * soil.tests[level.tests[i]].critical.eta_way;
  const double common = kOfTheWay * way;
  Estimate& mean = level.fit.mean;
  const double half = std::hypot((mean.high - mean.low) / 2, kNormal * common);
  mean.error = std::hypot(mean.error, common);
  mean.low = mean.value - half;
  mean.high = mean.value + half;
}

std::optional<Level> level_of_ratios(Soil& soil, const SoilOptions& options, const Gathered& all,
                                     const FitWords& words) {
  JudgedForm form = judged_form(all, FitKind::mean, words);
  add_cohesion(form, soil, all,
               [](const TestPoints& t) { return std::exp(t.critical.log_p.value); });
  auto level = level_of(soil, options, all, {form}, words);
  if (level) add_error_of_ways(soil, *level);
  return level;
}

/// Var(M_e/M)/(M_e/M)² = Var(M_e)/M_e² + Var(M)/M², with the degrees of Welch and Satterthwaite.
Estimate share(const Level& extension, const Level& compression) {
  const Estimate &e = extension.fit.mean, &c = compression.fit.mean;
  const double value = e.value / c.value;
  const double of_e = std::pow(e.error / e.value, 2), of_c = std::pow(c.error / c.value, 2);
  const double degrees =
      std::pow(of_e + of_c, 2) / (of_e * of_e / (e.tests - 1) + of_c * of_c / (c.tests - 1));
  return estimate(value, value * std::sqrt(of_e + of_c), std::max(degrees, 1.0), e.tests + c.tests);
}

void note_none(Soil& soil) {
  for (const auto& test : soil.tests)
    if (test.used && !test.cyclic && test.critical.kind == CriticalKind::none)
      soil.notes.push_back(
          fmt::format("{}: no critical state: {}", test.name, test.critical.reason));
}

void fit_lines(Soil& soil, const SoilOptions& options, const std::vector<bool>& with) {
  const FitWords words{"the critical state line", "e at the critical state"};
  std::vector<std::size_t> judged;
  const auto forms = critical_forms(soil, with, judged);
  Gathered odd;
  const Gathered left = without(critical_points(soil, with),
                                name_odd(soil, options, forms, judged, words), options, &odd);
  soil.critical_line = trend_through(soil, left, odd, words);
  if (!soil.critical_line) return;
  if (soil.critical_line->line.b > 0)
    soil.notes.emplace_back(
        "the critical state line rises with p′, which is impossible for sand: the tests are too "
        "few, too close together, or not of one sand");
  soil.critical_power = fit_power_line(soil.critical_line->points, options.exponent);
  if (soil.critical_power->exponent_held && !options.exponent)
    soil.notes.push_back(
        fmt::format("the tests do not determine the exponent of the power form, which is fixed at "
                    "{:g}: the intervals of the other two are for this exponent only",
                    kUsualExponent));
  // With one scatter allowed for, the form that needs less of it is the better one.
  soil.power_is_better = soil.critical_power->line.scatter < 0.8 * soil.critical_line->line.scatter;
}

}  // namespace

void fit_critical_states(Soil& soil, const SoilOptions& options) {
  note_none(soil);
  const auto with = with_stress(soil);
  fit_lines(soil, options, with);
  soil.critical_ratio = level_of_ratios(soil, options, critical_ratios(soil, with, false),
                                        {"M in compression", "η at the critical state", kUsualM});
  soil.extension_ratio = level_of_ratios(soil, options, critical_ratios(soil, with, true),
                                         {"M in extension", "|η| at the critical state", kUsualM});
  if (soil.critical_ratio && soil.extension_ratio)
    soil.extension_share = share(*soil.extension_ratio, *soil.critical_ratio);
}

}  // namespace triax::study
