// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/earlier_tests.hpp"

#include <algorithm>
#include <cmath>

#include "lab/collapse/stress_span.hpp"
#include "lab/measured/path_sampler.hpp"

namespace triax::lab {
namespace {

constexpr double kScatter = 0.007;  ///< s, of η among specimens of a sand
constexpr double kOfLaw = 0.004;    ///< likewise, of a calibrated law
constexpr double kByGive = 0.5;     ///< b, of η by x
constexpr double kStiff = 0.05;     ///< x up to which the pore fluid is as good as stiff

/// η at the true onset of a simulation; empty where it had none, or does not say where.
std::optional<double> true_eta(const std::optional<Truth>& truth) {
  if (!truth || !truth->lost_sustainability || !truth->q_pa || !truth->p_eff_pa) return {};
  return *truth->p_eff_pa > 0 ? std::optional(*truth->q_pa / *truth->p_eff_pa) : std::nullopt;
}

/// The forecast that the path came up to last, until that reading; the last one where it came up
/// to none.
const Forecast* reached_by(const std::vector<Forecast>& forecasts, std::int64_t reading) {
  const Forecast* at = nullptr;
  bool was_passed = false;
  for (const Forecast& one : forecasts) {
    if (one.reading > reading) break;
    const bool passed = one.left && one.left->value <= 0;
    if (!passed || !was_passed) at = &one;
    was_passed = passed;
  }
  return at;
}

}  // namespace

std::optional<EarlierTest> earlier_test(const RecordHeader& header, const TestSummary& summary,
                                        const std::vector<Forecast>& forecasts) {
  const Collapse& c = summary.collapse;
  const auto known = true_eta(summary.truth);
  if (!c.judged && !known) return std::nullopt;
  EarlierTest test{.name = header.name};
  if (header.origin == Origin::simulated) test.name += " (simulated)";
  for (const StageInfo& stage : header.stages) {
    const auto control = DrivenPath::control_of(&stage);
    if (is_watched(&stage) && control != DrivenPath::Control::none) test.control = control;
  }
  if (header.stages.empty()) test.control = DrivenPath::control_of(nullptr);
  if (test.control == DrivenPath::Control::none) return std::nullopt;
  if (const auto b = summary.consolidation.b_value; b && *b > 0)
    test.give = std::max(1 / *b - 1, 0.0);
  const bool carried_on = summary.truth && !summary.truth->lost_sustainability;
  if (known && c.inside_limit_surface != false) {
    test.onset = std::fabs(*known);
    test.by_law = true;
    test.in_extension = *known < 0;
  } else if (c.detected() && !carried_on) {
    if (!c.onset || !c.onset->eta() || c.inside_limit_surface == false) return std::nullopt;
    test.onset = std::fabs(*c.onset->eta());
    test.in_extension = *c.onset->eta() < 0;
    if (const auto& interval = c.onset->interval)
      test.onset_error = 0.5 * (interval->eta.high - interval->eta.low) / StressSpan::kOf95;
    const Forecast* reached =
        test.give > kStiff ? reached_by(forecasts, c.onset->reading) : nullptr;
    if (reached) {
      test.onset = std::fabs(reached->eta);
      test.onset_error = 0.5 * (reached->eta_high - reached->eta_low) / kOf90;
    }
  } else {
    if (!c.nearest || c.judged_until) return std::nullopt;
    test.min_work = c.nearest->normalised;
    test.in_extension = summary.peak && summary.peak->eta().value_or(0) < 0;
  }
  return test;
}

std::optional<EarlierTests::Onset> EarlierTests::onset(DrivenPath::Control control,
                                                       bool in_extension, double give) const {
  double weight = 0, sum = 0;
  const auto error_of = [&](const EarlierTest& t) {
    return std::hypot(t.by_law ? kOfLaw : kScatter, kByGive * (t.give - give), t.onset_error);
  };
  const auto each = [&](const auto& what) {
    for (const EarlierTest& t : tests_)
      if (t.onset && t.control == control && t.in_extension == in_extension)
        what(t, 1 / (error_of(t) * error_of(t)));
  };
  each([&](const EarlierTest& t, double w) { weight += w, sum += w * *t.onset; });
  if (!(weight > 0)) return std::nullopt;
  const double eta = sum / weight;
  // They scatter as their errors say, or by more; and the specimen to come scatters, too.
  double off = 0, count = 0;
  each([&](const EarlierTest& t, double w) {
    off += w * (*t.onset - eta) * (*t.onset - eta);
    ++count;
  });
  const double more = std::max(1.0, count > 1 ? off / (count - 1) : 1.0);
  return Onset{eta, std::sqrt(more / weight + kScatter * kScatter)};
}

bool EarlierTests::agree(DrivenPath::Control control, bool in_extension) const {
  return std::ranges::none_of(tests_, [&](const EarlierTest& t) {
    return !t.onset && t.control == control && t.in_extension == in_extension;
  });
}

std::optional<double> EarlierTests::carried_on(DrivenPath::Control control,
                                               bool in_extension) const {
  std::optional<double> least;
  for (const EarlierTest& t : tests_) {
    if (t.control != control || t.in_extension != in_extension) continue;
    if (t.onset) return std::nullopt;
    least = std::min(least.value_or(t.min_work), t.min_work);
  }
  return least;
}

}  // namespace triax::lab
