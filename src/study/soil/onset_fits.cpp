// SPDX-License-Identifier: GPL-3.0-or-later
// Stress ratio at the onset of collapse, and cyclic resistance.
#include <fmt/format.h>

#include <cmath>

#include "src/study/soil/soil_fits.hpp"

namespace triax::study {
namespace {

/// Of repeated tests: half a degree of friction, a tenth of CSR.
constexpr double kUsualOnset = 0.02, kUsualLogCsr = 0.1;
/// Of η over ψ₀, in triax's laws.
constexpr UsualCurve kOnsetCurve{.of_state = 10, .of_pressure = 0.1};

template <class X>
Gathered onsets_over(const Soil& soil, lab::CollapseKind kind, bool extension, const X& x) {
  Gathered all;
  for (std::size_t i = 0; i < soil.tests.size(); ++i) {
    const auto& test = soil.tests[i];
    if (!test.used || test.extension != extension || test.cyclic || test.collapse != kind) continue;
    const std::optional<double> at = x(test);
    if (test.onset_eta && at) all.add({*at, test.onset_eta->value, 0, test.onset_eta->error, 0}, i);
  }
  return all;
}

std::optional<double> psi(const TestPoints& t) {
  return t.state_parameter ? std::optional(t.state_parameter->value) : std::nullopt;
}
std::optional<double> log_p0(const TestPoints& t) {
  return t.p_eff_kPa ? std::optional(std::log(*t.p_eff_kPa)) : std::nullopt;
}

/// ψ of all tests comes from one line, whose error moves them together: a + b (ψ + δ), so that
/// Var(a) grows by b² Var(δ), which no scatter about the trend shows.
void add_error_of_line(const Soil& soil, Trend& trend) {
  double variance = 0;
  for (const std::size_t i : trend.tests) {
    const double error = soil.tests[i].state_parameter->error;
    variance += error * error / static_cast<double>(trend.tests.size());
  }
  trend.line.var_a += trend.line.b * trend.line.b * variance;
}

void fit_kind(Soil& soil, const SoilOptions& options, lab::CollapseKind kind, bool extension) {
  const std::string what = fmt::format(
      "η at the onset of {} in {}", kind == lab::CollapseKind::flow ? "flow" : "limited collapse",
      extension ? "extension" : "compression");
  const FitWords words{what, "η at the onset", kUsualOnset};
  const auto any = onsets_over(soil, kind, extension, log_p0);
  if (any.points.empty()) return;
  OnsetTrends trends{.kind = kind,
                     .extension = extension,
                     .over_state = {},
                     .over_void_ratio = {},
                     .over_pressure = {}};
  // Odd tests are named once, by the trend that explains most.
  const Gathered by_state = onsets_over(soil, kind, extension, psi);
  const FitWords of_state{what + " over ψ", words.value, words.usual, 0, kUsualPsi};
  trends.over_state =
      trend_of(soil, options, by_state,
               Forms{form_over_state(soil, by_state, of_state, kOnsetCurve)}, of_state);
  if (trends.over_state) add_error_of_line(soil, *trends.over_state);
  const auto others = [&](const Gathered& all) -> std::optional<Trend> {
    const auto line = fit_line(all.points);
    return line ? std::optional(Trend{*line, all.points, all.tests, {}, {}}) : std::nullopt;
  };
  trends.over_void_ratio =
      others(onsets_over(soil, kind, extension, [](const auto& t) { return t.void_ratio; }));
  trends.over_pressure = others(any);
  soil.onsets.push_back(std::move(trends));
}

using CycleOf = std::optional<lab::CycleInstant> lab::CyclicLoading::*;

void fit_resistance(Soil& soil, const SoilOptions& options, const std::string& criterion,
                    CycleOf cycle) {
  Gathered all;
  for (std::size_t i = 0; i < soil.tests.size(); ++i) {
    const auto& cyclic = soil.tests[i].cyclic;
    if (!soil.tests[i].used || !cyclic || !((*cyclic).*cycle) || cyclic->stress_ratio <= 0)
      continue;
    // A whole number of cycles, as the table has it: under way, half a cycle either way.
    const double n = ((*cyclic).*cycle)->cycle;
    all.add({std::log(n), std::log(cyclic->stress_ratio), 0.5 / n / std::sqrt(3.0), 0, 0}, i);
  }
  if (all.points.empty()) return;
  const FitWords words{"cyclic resistance to " + (criterion == "double_amplitude"
                                                      ? std::string("5 % double amplitude")
                                                      : std::string("r_u = 0.95")),
                       "ln CSR", kUsualLogCsr};
  if (auto trend = trend_of(soil, options, all, words))
    soil.cyclic.push_back({criterion, std::move(*trend)});
}

}  // namespace

void fit_onsets(Soil& soil, const SoilOptions& options) {
  for (const auto kind : {lab::CollapseKind::flow, lab::CollapseKind::limited})
    for (const bool extension : {false, true}) fit_kind(soil, options, kind, extension);
}

void fit_cyclic(Soil& soil, const SoilOptions& options) {
  fit_resistance(soil, options, "pore_pressure_ratio", &lab::CyclicLoading::liquefied);
  fit_resistance(soil, options, "double_amplitude", &lab::CyclicLoading::double_amplitude);
}

}  // namespace triax::study
