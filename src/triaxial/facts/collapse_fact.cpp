// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/facts/collapse_fact.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/measured/instant.hpp"
#include "lab/warning/warning_words.hpp"
#include "src/output/words.hpp"
#include "src/study/triaxial/test_result.hpp"
#include "src/triaxial/facts/cyclic_fact.hpp"
#include "src/triaxial/facts/guard_fact.hpp"
#include "src/triaxial/facts/run_away_fact.hpp"
#include "src/triaxial/facts/verdict_fact.hpp"

namespace triax::src {
namespace {

std::string limit_line(const db::StoredTest& test) {
  const lab::Collapse& collapse = test.summary.collapse;
  if (!collapse.limit_stress_ratio)
    return collapse.limit_source.empty() ? "unknown" : collapse.limit_source;
  auto line = fmt::format("M = {}", number(collapse.limit_stress_ratio, 3));
  if (const auto& intercept = collapse.limit_intercept_pa)
    line += fmt::format(", k = {} kPa (q = M p′ + k)", in_kPa(intercept));
  const bool of_the_law = test.header.origin == lab::Origin::simulated &&
                          test.header.specimen.limit_friction_angle_rad.has_value();
  if (of_the_law)
    line += " (friction angle of the specimen)";
  else if (!collapse.limit_source.empty())
    line += fmt::format(" ({})", collapse.limit_source);
  return line;
}

std::string work_line(const lab::Collapse& collapse) {
  auto line = number(collapse.second_order_work_normalised, 3);
  if (collapse.second_order_work_error) line += " ± " + number(collapse.second_order_work_error, 3);
  return line + " where it is first significant (normalised, between −1 and 1)";
}

std::string interval_line(const lab::StressInterval& at) {
  const auto kPa = [](const lab::Interval& of) {
    return fmt::format("{} to {} kPa", in_kPa(of.low), in_kPa(of.high));
  };
  return fmt::format("with 95 %: η {} to {}, q {}, p′ {}", number(at.eta.low, 3),
                     number(at.eta.high, 3), kPa(at.q_pa), kPa(at.p_eff_pa));
}

/// "total uncertainty: η 0.71 to 0.79; largest source: gain of the load cell, 41 %"
std::string total_line(const lab::TotalUncertainty& total) {
  std::string line = fmt::format("total uncertainty: η {} to {}", number(total.interval.eta.low, 3),
                                 number(total.interval.eta.high, 3));
  const auto largest = std::ranges::max_element(total.budget, {}, &lab::UncertaintySource::share);
  if (largest == total.budget.end()) return line;
  return line + fmt::format("; largest source: {}, {:.0f} %", largest->name, largest->share * 100);
}

/// What the alarm said first and did not take back.
std::vector<std::string> warning_lines(const lab::Collapse& collapse) {
  std::vector<std::string> lines;
  const auto add = [&](const char* level, const std::optional<lab::Forecast>& forecast) {
    if (!forecast) return;
    std::string line = fmt::format("{} at reading {}", level, forecast->reading);
    if (forecast->time_s) line += ", " + duration(forecast->time_s);
    lines.push_back(line + ": " + lab::describe(*forecast));
  };
  add("approaching", collapse.approaching);
  add("imminent", collapse.imminent);
  return lines;
}

/// The onset lies between readings, its values are fitted: the reading's own stand below.
std::vector<std::string> onset_lines(const db::StoredTest& test, const lab::Instant& onset) {
  std::vector<std::string> lines = {instant(onset)};
  if (onset.interval) lines.push_back(interval_line(*onset.interval));
  if (onset.total) lines.push_back(total_line(*onset.total));
  if (test.summary.collapse.detected())
    lines.push_back(detected_line(onset, test.summary.collapse.onset_detected_at));
  if (test.state_at_onset)
    lines.push_back("values of that reading: " +
                    stress_and_strain(lab::instant_of(*test.state_at_onset, false)));
  return lines;
}

std::vector<std::string> loss_of_control_lines(const lab::Collapse& collapse) {
  const auto& lost = collapse.loss_of_control;
  if (!lost) return {"none"};
  std::vector<std::string> lines = {instant(*lost)};
  if (lost->interval) lines.push_back(interval_line(*lost->interval));
  lines.push_back(detected_line(*lost, collapse.loss_of_control_detected_at));
  return lines;
}

/// What is known of it: "12.5 s, ε₁ 0.52 %, q 60.0 kPa".
std::string values_line(const lab::Instant& at) {
  std::vector<std::string> parts;
  if (at.time_s) parts.push_back(duration(at.time_s));
  if (at.axial_strain) parts.push_back(fmt::format("ε₁ {} %", in_percent(at.axial_strain)));
  if (at.q_pa) parts.push_back(fmt::format("q {} kPa", in_kPa(at.q_pa)));
  if (at.p_eff_pa) parts.push_back(fmt::format("p′ {} kPa", in_kPa(at.p_eff_pa)));
  if (at.eta()) parts.push_back(fmt::format("η {}", number(at.eta(), 2)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::string detected_line(const lab::Instant& at, const std::optional<lab::Moment>& detected_at) {
  if (!detected_at) return "detected only when the record had ended";
  std::string line = fmt::format("detected at reading {}", detected_at->reading);
  if (detected_at->time_s) line += ", " + duration(detected_at->time_s);
  const std::int64_t after = detected_at->reading - at.reading;
  return line + (after == 1 ? std::string("; one reading later")
                            : fmt::format("; {} readings later", after));
}

std::string truth_line(const lab::Truth& truth) {
  if (!truth.lost_sustainability) return "the simulated specimen remained stable";
  const bool fell = std::ranges::any_of(truth.run_aways, [&](const lab::RunAwayTruth& run_away) {
    return run_away.start_s == truth.time_s;
  });
  return fmt::format(
      "the simulated specimen {} at {}",
      fell ? "lost its equilibrium (runaway, W₂ still positive)" : "became unstable (W₂ < 0)",
      values_line(study::true_instant(truth)));
}

void add_collapse(std::vector<Fact>& facts, const db::StoredTest& test) {
  const auto& collapse = test.summary.collapse;
  facts.push_back({"Collapse", {verdict_line(test)}});
  if (test.summary.guard) facts.push_back({"Intervention", guard_lines(*test.summary.guard)});
  if (!study::has_verdict(test)) {
    if (collapse.loss_of_control)
      facts.push_back({"Loss of control", loss_of_control_lines(collapse)});
    return;
  }
  if (const auto onset = study::collapse_onset(test))
    facts.push_back({"Onset of instability", onset_lines(test, *onset)});
  facts.push_back({"Loss of control", loss_of_control_lines(collapse)});
  if (const auto lines = warning_lines(collapse); !lines.empty()) facts.push_back({"Alarm", lines});
  if (const auto failure = study::failure_onset(test))
    facts.push_back({"Failure", onset_lines(test, *failure)});
  facts.push_back(
      {"Peak of q", {test.summary.peak ? instant(*test.summary.peak) : std::string(kUnknown)}});
  if (test.summary.cyclic) facts.push_back({"Cycles", cyclic_lines(*test.summary.cyclic)});
  if (collapse.detected()) facts.push_back({"Second-order work", {work_line(collapse)}});
  facts.push_back({"Limit surface", {limit_line(test)}});
  if (test.summary.truth)
    facts.push_back({"True onset (model)", {truth_line(*test.summary.truth)}});
  if (const auto lost =
          test.summary.truth ? study::true_loss_of_control(*test.summary.truth) : std::nullopt)
    facts.push_back({"True loss of control", {values_line(*lost)}});
  if (test.summary.truth && !test.summary.truth->run_aways.empty())
    facts.push_back({"Runaway", run_away_lines(test.summary.truth->run_aways)});
}

}  // namespace triax::src
