// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "lab/results/quantity.hpp"
#include "lab/rig/rig_software.hpp"
#include "lab/rig/supervision.hpp"
#include "lab/wire/served/served_rig.hpp"
#include "tests/wire/faults/rig_of_trial.hpp"
#include "tests/wire/faults/trial.hpp"

namespace triax::lab::test {
namespace {

class Judging {
 public:
  Judging(const TrialPlan& plan, const TrialLog& log) : plan_(plan), log_(log) {}

  Verdict all() {
    if (!log_.failed.empty()) complain("failed: " + log_.failed);
    for (const Look& look : log_.looks) judge_look(look);
    for (std::size_t i = 0; i < plan_.wrongs.size() && i < log_.lasted.size(); ++i)
      judge_wrong(plan_.wrongs[i], log_.lasted[i].first, log_.lasted[i].second);
    judge_safety();
    judge_rest();
    return std::move(verdict_);
  }

 private:
  void complain(std::string text) {
    if (verdict_.complaints.size() < 5) verdict_.complaints.push_back(std::move(text));
  }
  bool wrong_at(const std::string& instrument) const {
    return std::ranges::any_of(plan_.wrongs,
                               [&](const Wrong& w) { return w.instrument == instrument; });
  }

  /// Digits of the wire: nine of the meter, 24 bits of a Modbus float; shortest doubles by SCPI.
  double digits_of(const std::string& instrument, double si) const {
    return std::fabs(si) * (plan_.modbus && instrument != "scanner" ? 6e-8 : 1e-8) + 1e-15;
  }

  /// The plant's readings that an answer between these instants may hold.
  std::pair<std::size_t, std::size_t> ticks_between(double from_s, double to_s) const {
    const auto after = [&](double at) {
      return static_cast<std::size_t>(
          std::ranges::upper_bound(log_.plant, at, {}, &PlantTick::at_s) - log_.plant.begin());
    };
    return {std::max<std::size_t>(after(from_s), 1) - 1, after(to_s)};
  }

  void judge_look(const Look& look) {
    const auto [from, to] = ticks_between(look.asked_s, look.answered_s);
    take_news(look);
    for (const auto& row : raw_channels()) {
      const double said = look.reading[row.quantity];
      const std::string at = instrument_of(std::string(row.name), plan_.modbus);
      if (std::isnan(said)) {
        judge_missing(look, at, std::string(row.name));
        continue;
      }
      ++verdict_.cells;
      const double allowed = digits_of(at, said);
      const auto is = [&](const PlantTick& tick) {
        return std::fabs(tick.reading[row.quantity] - said) <= allowed;
      };
      const auto begin = log_.plant.begin();
      if (std::none_of(begin + std::ptrdiff_t(from), begin + std::ptrdiff_t(to), is))
        complain(fmt::format("invented: {} {} at {:.3f} s", row.name, said, look.asked_s));
      verdict_.told_apart += from >= 12 && !is(log_.plant[from - 12]);
      if (not_taken_.contains(at))
        complain(fmt::format("{} of another instrument was taken from {}", row.name, at));
    }
  }

  /// Gaps that are open behind a look, by the events of the tick that follows it.
  void take_news(const Look& look) {
    for (const Event& event : look.events) {
      const std::string name = event.detail.substr(0, event.detail.find(' '));
      if (event.detail.find(" clock ") != std::string::npos) {  // no gap
        told_.emplace_back(name, event.detail);
        if (!wrong_at(name) && log_.stall_s < 0.1)
          complain("a clock that is right: " + event.detail);
      } else if (event.detail.find("responds again") != std::string::npos) {
        if (open_.erase(name) == 0) complain("the end of no gap is told: " + event.detail);
        not_taken_.erase(name);
      } else {
        open_.insert(name);
        told_.emplace_back(name, event.detail);
        for (const Wrong& wrong : plan_.wrongs)
          if (wrong.instrument == name && !wrong.not_taken_with.empty() &&
              event.detail.find(wrong.not_taken_with) != std::string::npos)
            not_taken_.insert(name);
        if (!wrong_at(name) && log_.stall_s < 0.1)
          complain("of an instrument that is all right: " + event.detail);
      }
    }
  }

  void judge_missing(const Look& look, const std::string& at, const std::string& channel) {
    ++verdict_.missing;
    // Where the test ended no tick follows.
    if (look.over_s > 0 && !open_.contains(at))
      complain(fmt::format("{} is missing at {:.3f} s, and nothing tells of {}", channel,
                           look.asked_s, at));
  }

  void judge_wrong(const Wrong& wrong, double from_s, double to_s) {
    if (from_s == 0 || log_.looks.empty()) return;
    const double seen_s = log_.looks.back().over_s;
    const auto ours = [&](const auto& told) {
      return told.first == wrong.instrument &&
             (wrong.causes.empty() || std::ranges::any_of(wrong.causes, [&](const auto& cause) {
                return told.second.find(cause) != std::string::npos;
              }));
    };
    const bool told = std::ranges::any_of(told_, ours);
    if (wrong.causes.empty()) {
      // No time is left to ask again for an unusual value: it is missing until later replies
      // confirm it.
      const auto is_gap = [&](const auto& event) {
        return ours(event) && event.second.find("response rejected") == std::string::npos;
      };
      const auto gap = std::ranges::find_if(told_, is_gap);
      if (gap != told_.end() && plan_.wrongs.size() == 1 && log_.stall_s < 0.05)
        complain("a gap although answers came in time: " + gap->second);
      return;
    }
    const bool long_enough = wrong.for_s > 1;
    const bool seen = seen_s > std::min(from_s + 1.5, to_s > 0 ? to_s : 1e9);
    if (long_enough && seen && !told && !other_hides(wrong))
      complain(fmt::format("{} of {} is not told with its cause", wrong.kind, wrong.instrument));
    if (to_s == 0 || seen_s < to_s + 1.8 || log_.safe_s > 0) return;
    if (open_.contains(wrong.instrument))
      complain(fmt::format("{} is not back {:.1f} s after {}", wrong.instrument, seen_s - to_s,
                           wrong.kind));
  }

  bool other_hides(const Wrong& wrong) const {
    return std::ranges::any_of(plan_.wrongs, [&](const Wrong& other) {
      return &other != &wrong && other.instrument == wrong.instrument;
    });
  }

  /// Safe in time where something needed was away for too long; not where nothing was.
  void judge_safety() {
    double due_s = 1e9;
    bool none_long = true;
    for (std::size_t i = 0; i < plan_.wrongs.size() && i < log_.lasted.size(); ++i) {
      const Wrong& wrong = plan_.wrongs[i];
      if (!wrong.cuts || log_.lasted[i].first == 0) continue;
      if (wrong.for_s > Supervision::kDeaf_s)
        due_s = std::min(due_s, log_.lasted[i].first + Supervision::kDeaf_s + kDeadline_s +
                                    RigSoftware::kTick_s + slack_s());
      // Up to a deadline later the first good answer comes.
      none_long = none_long && wrong.for_s + plan_.deadline_s < Supervision::kDeaf_s - 0.5;
    }
    const bool safe = log_.safe_s > 0;
    double rest_s = 0;
    for (const Look& look : log_.looks)
      if (!look.running && rest_s == 0) rest_s = look.over_s;
    verdict_.safe = safe;
    const double asked_s = safe_look_s();
    if (due_s < 1e8 && (asked_s == 0 || asked_s > due_s))
      complain(safe ? fmt::format("safe state {:.2f} s too late", asked_s - due_s)
                    : "no safe state although something needed was away");
    if (none_long && safe && log_.stall_s < 0.2)
      complain("safe state although nothing was away for long: " + reason());
  }
  std::string reason() const {
    for (const Event& event : log_.events)
      if (event.kind == EventKind::safe_state) return event.detail;
    return {};
  }
  /// When the look was over at which the software decided for it.
  double safe_look_s() const {
    const auto found = std::ranges::find(log_.looks, false, &Look::running);
    return found == log_.looks.end() ? 0 : found->answered_s;
  }
  /// What the machine kept threads waiting adds to times.
  double slack_s() const { return 0.05 + 2 * log_.stall_s; }

  /// In the safe state nothing moves: orders that cannot arrive are made good by watchdogs.
  void judge_rest() {
    if (log_.safe_s == 0 || log_.plant.size() < 10) return;
    const PlantTick &last = log_.plant.back(), &before = log_.plant.end()[-8];
    if (!last.stopped) complain("the frame moves in the safe state");
    if (last.cell_set_pa != before.cell_set_pa) complain("the cell pressure is still driven");
    if (last.back_set_pa != before.back_set_pa) complain("the back pressure is still driven");
  }

  const TrialPlan& plan_;
  const TrialLog& log_;
  Verdict verdict_;
  std::set<std::string> open_, not_taken_;
  std::vector<std::pair<std::string, std::string>> told_;
};

}  // namespace

Verdict judge(const TrialPlan& plan, const TrialLog& log) { return Judging(plan, log).all(); }

}  // namespace triax::lab::test
