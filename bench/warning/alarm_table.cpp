// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/warning/alarm_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

namespace triax::bench {
namespace {

using Group = std::vector<const AlarmTrial*>;

double percent(std::int64_t part, std::int64_t whole) {
  return whole ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : NAN;
}

double median(std::vector<double> values) {
  if (values.empty()) return NAN;
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

void print_collapses(const std::string& name, const Group& group) {
  if (group.empty()) return;
  std::int64_t warned = 0, in_time = 0;
  std::vector<double> leads;
  for (const auto* t : group) {
    warned += t->warned();
    in_time += t->warned() && t->lead_s() >= std::min(0.1 * t->stage_s, 60.0);
    if (t->warned()) leads.push_back(t->lead_s());
  }
  const auto all = static_cast<std::int64_t>(group.size());
  fmt::print("{:16} {:5}   {:6.1f} {:8.0f} {:8.1f} ", name, all, percent(warned, all),
             median(leads), percent(in_time, all));
  for (std::size_t i = 0; i < kLeft.size(); ++i) {
    std::vector<double> errors;
    std::int64_t covered = 0, good = 0;
    for (const auto* t : group)
      if (t->looks[i]) {
        errors.push_back(std::fabs(t->looks[i]->error));
        covered += t->looks[i]->covered;
        good += errors.back() <= 0.02;
      }
    const auto seen = static_cast<std::int64_t>(errors.size());
    fmt::print("  {:5.1f} {:7.4f} {:6.1f} {:6.1f}", percent(seen, all), median(errors),
               percent(good, all), percent(covered, seen));
  }
  fmt::print("\n");
}

void print_controls(const std::string& name, const Group& group) {
  if (group.empty()) return;
  std::int64_t imminent = 0, approaching = 0, points = 0, wrong = 0;
  for (const auto* t : group) {
    imminent += t->imminent;
    approaching += t->approaching_at_end;
    points += t->points;
    wrong += t->wrong_points;
  }
  const auto all = static_cast<std::int64_t>(group.size());
  fmt::print("{:42} {:5} {:10.2f} {:22.2f} {:14.2f}\n", name, all, percent(imminent, all),
             percent(approaching, all), percent(wrong, points));
}

std::string driven(const AlarmTrial& t) { return t.type + (t.under_force ? " by force" : ""); }

void print_head() {
  fmt::print("{:16} {:>5}   {:>6} {:>8} {:>8} ", "driven", "tests", "warned", "lead", "in time");
  for (const double left : kLeft)
    fmt::print("  {:>5} |error| 0.02 covers", fmt::format("{:.0f} %", left * 100));
  fmt::print("\n{:16} {:>5}   {:>6} {:>8} {:>8} ", "", "", "%", "median s", "%");
  for (std::size_t i = 0; i < kLeft.size(); ++i)
    fmt::print("  {:>5} {:>7} {:>6} {:>6}", "seen", "median", "%", "%");
  fmt::print("\n");
}

Group among(const Group& all, const std::function<bool(const AlarmTrial&)>& which) {
  Group group;
  std::ranges::copy_if(all, std::back_inserter(group), [&](const auto* t) { return which(*t); });
  return group;
}

/// In the order of their first appearance.
std::vector<std::string> names(const Group& group,
                               const std::function<std::string(const AlarmTrial&)>& name) {
  std::vector<std::string> all;
  for (const auto* t : group)
    if (std::ranges::find(all, name(*t)) == all.end()) all.push_back(name(*t));
  return all;
}

std::string specimen(const AlarmTrial& t) { return t.programme + " " + t.material; }

void print_all_collapses(const Group& collapses) {
  print_head();
  for (const std::string& kind : names(collapses, driven))
    print_collapses(kind, among(collapses, [&](const auto& t) { return driven(t) == kind; }));
  print_collapses("all by force", among(collapses, [](const auto& t) { return t.under_force; }));
  print_collapses("all displacement",
                  among(collapses, [](const auto& t) { return !t.under_force; }));
  constexpr std::array kInstruments = {"good", "standard", "cheap"};
  const auto by_instruments = [](const Group& group, const std::string& name, std::size_t i) {
    print_collapses(name, among(group, [&](const auto& t) {
                      return static_cast<std::size_t>(t.instruments) == i;
                    }));
  };
  for (std::size_t i = 0; i < kInstruments.size(); ++i)
    by_instruments(collapses, kInstruments[i], i);
  struct Interval {
    const char* name;
    double least, most;  // s
  };
  for (const auto& [name, least, most] :
       {Interval{"0.1 to 1 s", 0, 1}, {"1 to 10 s", 1, 10}, {"10 to 60 s", 10, 61}}) {
    const Group group = among(
        collapses, [=](const auto& t) { return t.interval_s >= least && t.interval_s < most; });
    print_collapses(name, group);
    for (std::size_t i = 0; i < kInstruments.size(); ++i)
      by_instruments(group, fmt::format("  {}", kInstruments[i]), i);
  }
  print_collapses("below 30 reading",
                  among(collapses, [](const auto& t) { return t.stage_readings < 30; }));
  print_collapses("air in the pores", among(collapses, [](const auto& t) { return t.air; }));
  print_collapses("no air", among(collapses, [](const auto& t) { return !t.air; }));
  constexpr std::array kWays = {"straight on", "after a rest", "after a loop"};
  for (std::size_t i = 0; i < kWays.size(); ++i)
    print_collapses(kWays[i], among(collapses, [&](const auto& t) {
                      return static_cast<std::size_t>(t.interruption) == i;
                    }));
  for (const std::string& law : names(collapses, &AlarmTrial::law))
    print_collapses(law, among(collapses, [&](const auto& t) { return t.law() == law; }));
  print_collapses("all", collapses);
}

Group clear_of_zero(const Group& controls) {
  return among(controls, [](const auto& t) { return !t.near_zero(); });
}

void print_all_controls(const Group& controls) {
  fmt::print("\n{:42} {:>5} {:>10} {:>22} {:>14}\n", "controls", "tests", "imminent %",
             "approaching at end %", "wrong points %");
  for (const std::string& kind : names(controls, specimen))
    print_controls(kind, among(controls, [&](const auto& t) { return specimen(t) == kind; }));
  print_controls("all", controls);
  print_controls("all that kept clear of zero work", clear_of_zero(controls));
  const Group near = among(controls, &AlarmTrial::near_zero);
  print_controls("those near zero work", near);
  for (const std::string& kind : names(near, specimen))
    print_controls("  " + kind, among(near, [&](const auto& t) { return specimen(t) == kind; }));
}

void print_failures(const Group& collapses, const Group& controls) {
  for (const auto* t : controls)
    if (t->imminent || t->approaching_at_end)
      fmt::print(
          "control {} seed {}, least work {:.3f}, error of it {:.3f}, interval {:.3g} s{}:{}\n",
          specimen(*t), t->seed, t->least_work, t->work_error, t->interval_s, t->air ? ", air" : "",
          t->said);
  for (const auto* t : collapses)
    if (!t->warned() || !t->looks[1] || std::fabs(t->looks[1]->error) > 0.02)
      fmt::print(
          "{} seed {} {} interval {:.3g} s, {} readings, lead {:.0f} s of {:.0f}, error at 10 %: "
          "{:+.3f}; fall {:.0f} s;{}\n",
          specimen(*t), t->seed, t->warned() ? "warned" : "NOT WARNED", t->interval_s,
          t->stage_readings, t->lead_s(), t->stage_s, t->looks[1] ? t->looks[1]->error : NAN,
          t->fall_s, t->said);
}

/// One line a bound; false where it is not held.
bool hold(bool held, const std::string& what) {
  fmt::print("{} {}\n", held ? "held:    " : "NOT held:", what);
  return held;
}

bool print_bounds(const Group& collapses, const Group& controls) {
  const auto share = [](const Group& group, const std::function<bool(const AlarmTrial&)>& is) {
    return percent(static_cast<std::int64_t>(among(group, is).size()),
                   static_cast<std::int64_t>(group.size()));
  };
  const Group force = among(collapses, [](const auto& t) { return t.under_force; });
  const Group frame = among(collapses, [](const auto& t) { return !t.under_force; });
  const auto warned = [](const AlarmTrial& t) { return t.warned(); };
  std::vector<double> leads;
  for (const auto* t : force)
    if (t->warned()) leads.push_back(t->lead_s() / std::min(0.1 * t->stage_s, 60.0));
  std::int64_t points = 0, wrong = 0;
  for (const auto* t : controls) points += t->points, wrong += t->wrong_points;
  bool all = true;
  const auto at_least = [&](double value, double asked, const char* what) {
    all &=
        hold(value >= asked, fmt::format("{:.1f} % {}, asked {:g} % at least", value, what, asked));
  };
  const auto at_most = [&](double value, double asked, const char* what) {
    all &=
        hold(value <= asked, fmt::format("{:.1f} % {}, asked {:g} % at most", value, what, asked));
  };
  fmt::print("\n");
  at_least(share(force, warned), 99, "of falls under force warned of before");
  at_least(share(frame, warned), 95, "of onsets by displacement reported within ten readings");
  const double lead = median(leads);
  all &= hold(lead >= 1, fmt::format("median lead {:.1f} times the shorter of a tenth of the stage "
                                     "and 60 s, asked 1 at least",
                                     lead));
  at_least(share(collapses,
                 [](const auto& t) { return t.looks[1] && std::fabs(t.looks[1]->error) <= 0.02; }),
           90, "of forecasts at 10 % left within 0.02 of η");
  for (std::size_t i = 0; i < kLeft.size(); ++i) {
    const Group seen = among(collapses, [&](const auto& t) { return t.looks[i].has_value(); });
    const double covered = share(seen, [&](const auto& t) { return t.looks[i]->covered; });
    all &= hold(covered >= 85 && covered <= 95,
                fmt::format("{:.1f} % of 90 % intervals at {:.0f} % left hold the onset, asked 85 "
                            "to 95 %",
                            covered, kLeft[i] * 100));
  }
  const auto imminent = [](const AlarmTrial& t) { return t.imminent; };
  at_most(share(controls, imminent), 1, "of controls imminent");
  at_most(share(clear_of_zero(controls), imminent), 1,
          "of controls imminent whose work kept clear of zero");
  at_most(share(controls, [](const auto& t) { return t.approaching_at_end; }), 5,
          "of controls approaching at the end");
  at_most(percent(wrong, points), 2, "of points in controls under a level");
  return all;
}

}  // namespace

bool print_alarm_trials(const std::string& title, const std::vector<AlarmTrial>& trials,
                        bool failures) {
  Group collapses, controls;
  for (const auto& t : trials)
    if (!t.programme.empty() && t.comparable()) (t.collapses ? collapses : controls).push_back(&t);
  fmt::print("{}: {} collapses, {} controls, of {} tests\n\n", title, collapses.size(),
             controls.size(), trials.size());
  print_all_collapses(collapses);
  print_all_controls(controls);
  const bool held = print_bounds(collapses, controls);
  if (failures) print_failures(collapses, controls);
  return held;
}

}  // namespace triax::bench
