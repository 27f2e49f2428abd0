// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace triax::bench {
namespace {

std::string cell(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

std::string line(std::string_view method, std::string_view type,
                 const std::vector<Outcome>& outcomes) {
  const Summary s = summarise(outcomes);
  const auto share = [](int part, int whole) {
    return whole > 0 ? fmt::format("{:.2f}", 100.0 * part / whole) : std::string("-");
  };
  const bool live = method == kMethods.front();  // the others look afterwards
  return fmt::format(
      "{:<31} {:<9} {:>6} {:>9} {:>7} {:>7} {:>7} {:>7} {:>6} {:>6} {:>6} {:>6} "
      "{:>6} {:>6} {:>6}\n",
      method, type, outcomes.size(), share(s.detected, s.collapsing),
      share(s.false_alarms, s.controls), cell(s.eta_error.half, 4), cell(s.eta_error.most, 4),
      cell(s.eta_error.all, 4), cell(s.delay.half, 0), cell(s.delay.most, 0), cell(s.delay.all, 0),
      cell(s.notice_delay.half, 0), cell(s.notice_delay.most, 0), cell(s.notice_delay.all, 0),
      live ? std::to_string(s.unnoticed) : "-");
}

/// Outcomes of one method by type of programme, the controls of all types together.
std::map<std::string, std::vector<Outcome>> by_type(const std::vector<TrialResult>& results,
                                                    std::size_t method) {
  std::map<std::string, std::vector<Outcome>> groups;
  for (const TrialResult& r : results)
    if (r.comparable()) groups[r.collapses ? r.type : "controls"].push_back(r.outcomes[method]);
  return groups;
}

std::vector<Outcome> all(const std::vector<TrialResult>& results, std::size_t method) {
  std::vector<Outcome> outcomes;
  for (const TrialResult& r : results)
    if (r.comparable()) outcomes.push_back(r.outcomes[method]);
  return outcomes;
}

}  // namespace

std::string table(const std::vector<TrialResult>& results) {
  std::string text =
      fmt::format("{:<31} {:<9} {:>6} {:>9} {:>7} {:^23} {:^20} {:^27}\n", "", "", "", "detected",
                  "false", "|error of eta|", "|delay|, readings", "noticed after, readings");
  text += fmt::format(
      "{:<31} {:<9} {:>6} {:>9} {:>7} {:>7} {:>7} {:>7} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6} "
      "{:>6}\n",
      "method", "type", "tests", "%", "alarm %", "50 %", "95 %", "max", "50 %", "95 %", "max",
      "50 %", "95 %", "max", "never");
  for (std::size_t method = 0; method < kMethods.size(); ++method) {
    for (const auto& [type, outcomes] : by_type(results, method))
      text += line(kMethods[method], type, outcomes);
    text += line(kMethods[method], "all", all(results, method));
  }
  const auto without =
      std::ranges::count_if(results, [](const auto& r) { return !r.comparable(); });
  if (without > 0)
    text += fmt::format("{} specimens did not collapse where they were to; left out\n", without);
  return text;
}

std::vector<std::string> broken(const std::vector<TrialResult>& results, const Bounds& bounds,
                                bool whole) {
  const auto ours = all(results, 0);
  const Summary s = summarise(ours);
  std::vector<std::string> found;
  const auto hold = [&](bool holds, const std::string& text) {
    if (!holds) found.push_back(text);
  };
  hold(!whole || std::ssize(ours) >= bounds.tests,
       fmt::format("{} tests, at least {} are asked", ours.size(), bounds.tests));
  hold(s.detection() >= bounds.detection,
       fmt::format("{:.2f} % detected, at least {:g} % are asked", 100 * s.detection(),
                   100 * bounds.detection));
  hold(s.false_alarm() <= bounds.false_alarm,
       fmt::format("{:.2f} % false alarms, at most {:g} % are allowed", 100 * s.false_alarm(),
                   100 * bounds.false_alarm));
  hold(s.eta_error.most.value_or(0) <= bounds.eta_error,
       fmt::format("error of eta {:.4f} for 95 % of the tests, at most {:g} is allowed",
                   s.eta_error.most.value_or(0), bounds.eta_error));
  hold(s.delay.most.value_or(0) <= bounds.delay,
       fmt::format("delay {:.0f} readings for 95 % of the tests, at most {:g} are allowed",
                   s.delay.most.value_or(0), bounds.delay));
  return found;
}

std::string csv(const std::vector<TrialResult>& results) {
  std::string text =
      "trait,programme,type,material,seed,readings,expected,truth_lost,truth_reading,truth_eta,"
      "kind,method,detected,eta_error,delay_readings,noticed_after_readings,eta_low,eta_high\n";
  const auto number = [](const auto& value) {
    return value ? fmt::format("{}", *value) : std::string();
  };
  for (const TrialResult& r : results)
    for (std::size_t i = 0; i < kMethods.size(); ++i) {
      const Outcome& o = r.outcomes[i];
      const std::string truth =
          r.truth_lost ? fmt::format("{},{:.6f}", r.truth_reading, r.truth_eta) : std::string(",");
      const bool has_interval = i == 0 && r.interval;
      const std::string interval =
          has_interval ? fmt::format("{:.6f},{:.6f}", r.interval->eta.low, r.interval->eta.high)
                       : std::string(",");
      text +=
          fmt::format("\"{}\",{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", r.trait, r.programme,
                      r.type, r.material, r.seed, r.readings, r.collapses ? "collapse" : "stable",
                      r.truth_lost, truth, i == 0 ? r.kind : "", kMethods[i], o.detected,
                      number(o.eta_error), number(o.delay), number(o.notice_delay), interval);
    }
  return text;
}

}  // namespace triax::bench
