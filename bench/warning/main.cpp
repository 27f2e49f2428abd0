// SPDX-License-Identifier: GPL-3.0-or-later
// bench_warning: what is said of an onset before it comes, over simulated tests, in memory.
//
//   warned    `imminent` stood before the fall (load, dead load, spring, held q), or within ten
//             readings after the onset (displacement)
//   lead      time from `imminent` to the fall: its median
//   in time   share of tests in which it is a tenth of the stage or 60 s, whichever is shorter
//   |error|   of η forecast with that share of the stage's time left: median, share within 0.02
//   covers    share of tests whose 90 % interval holds the true η
//   controls  tests that stay stable: `imminent` ever, `approaching` at the end, points of
//             second-order work under a level
// No bound is asked yet.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <thread>
#include <vector>

#include "bench/detection/subjects.hpp"
#include "bench/warning/alarm_trial.hpp"
#include "bench/warning/guard_trial.hpp"
#include "lab/base/bad_input.hpp"

using namespace triax;

namespace {

struct Options {
  int seeds = 40, from = 1;
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::string only, list = "bench/warning/programmes.txt", folder = "samples/programmes";
  bool failures = false, guard = false;
};

template <class Trial>
std::vector<Trial> run_all(const std::vector<bench::Subject>& subjects, const Options& o,
                           Trial (*trial)(const bench::Subject&, std::uint64_t)) {
  std::vector<Trial> trials(subjects.size() * static_cast<std::size_t>(o.seeds));
  std::atomic<std::size_t> next = 0;
  std::mutex guard;
  const auto work = [&] {
    for (std::size_t i = next++; i < trials.size(); i = next++) {
      const auto seed = static_cast<std::uint64_t>(o.from) + i / subjects.size();
      try {
        trials[i] = trial(subjects[i % subjects.size()], seed);
      } catch (const std::exception& e) {
        const std::lock_guard lock(guard);
        fmt::print(stderr, "{} seed {}: {}\n", subjects[i % subjects.size()].programme.name, seed,
                   e.what());
      }
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < o.jobs; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return trials;
}

using Group = std::vector<const bench::AlarmTrial*>;

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
  for (std::size_t i = 0; i < bench::kLeft.size(); ++i) {
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
  fmt::print("{:30} {:5} {:10.2f} {:22.2f} {:14.2f}\n", name, all, percent(imminent, all),
             percent(approaching, all), percent(wrong, points));
}

std::string driven(const bench::AlarmTrial& t) {
  return t.type + (t.under_force ? " by force" : "");
}

int run(const Options& o) {
  auto subjects = bench::read_subjects(o.list, o.folder);
  if (!o.only.empty())
    std::erase_if(subjects, [&](const auto& s) {
      return s.programme.name.find(o.only) == std::string::npos;
    });
  if (o.guard) {
    bench::print_guard_trials(run_all(subjects, o, bench::run_guard_trial), o.failures);
    return 0;
  }
  const auto trials = run_all(subjects, o, bench::run_alarm_trial);
  std::vector<std::string> kinds;
  Group collapses, controls;
  for (const auto& t : trials) {
    if (t.programme.empty() || !t.comparable()) continue;
    (t.collapses ? collapses : controls).push_back(&t);
    const std::string kind = t.collapses ? driven(t) : t.programme + " " + t.material;
    if (std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(kind);
  }
  fmt::print("{} collapses, {} controls, of {} tests\n\n", collapses.size(), controls.size(),
             trials.size());
  fmt::print("{:16} {:>5}   {:>6} {:>8} {:>8} ", "driven", "tests", "warned", "lead", "in time");
  for (const double left : bench::kLeft)
    fmt::print("  {:>5} |error| 0.02 covers", fmt::format("{:.0f} %", left * 100));
  fmt::print("\n{:16} {:>5}   {:>6} {:>8} {:>8} ", "", "", "%", "median s", "%");
  for (std::size_t i = 0; i < bench::kLeft.size(); ++i)
    fmt::print("  {:>5} {:>7} {:>6} {:>6}", "seen", "median", "%", "%");
  fmt::print("\n");
  for (const std::string& kind : kinds) {
    Group group;
    std::ranges::copy_if(collapses, std::back_inserter(group),
                         [&](const auto* t) { return driven(*t) == kind; });
    print_collapses(kind, group);
  }
  Group force, displacement;
  for (const auto* t : collapses) (t->under_force ? force : displacement).push_back(t);
  print_collapses("all by force", force);
  print_collapses("all displacement", displacement);
  for (const auto instruments :
       {bench::Instruments::good, bench::Instruments::standard, bench::Instruments::cheap}) {
    Group group;
    std::ranges::copy_if(collapses, std::back_inserter(group),
                         [&](const auto* t) { return t->instruments == instruments; });
    print_collapses(std::array{"good", "standard", "cheap"}[static_cast<std::size_t>(instruments)],
                    group);
  }
  print_collapses("all", collapses);
  fmt::print("\n{:30} {:>5} {:>10} {:>22} {:>14}\n", "controls", "tests", "imminent %",
             "approaching at end %", "wrong points %");
  for (const std::string& kind : kinds) {
    Group group;
    std::ranges::copy_if(controls, std::back_inserter(group),
                         [&](const auto* t) { return t->programme + " " + t->material == kind; });
    print_controls(kind, group);
  }
  print_controls("all", controls);
  if (o.failures)
    for (const auto* t : controls)
      if (t->imminent || t->approaching_at_end)
        fmt::print("control {} {} seed {}:{}\n", t->programme, t->material, t->seed, t->said);
  if (o.failures)
    for (const auto* t : collapses)
      if (!t->warned() || (t->looks[1] && std::fabs(t->looks[1]->error) > 0.02) || !t->looks[1])
        fmt::print(
            "{} {} seed {} {} interval {:.3g} s, {} readings, lead {:.0f} s of {:.0f}, error at 10 "
            "%: {:+.3f}; fall {:.0f} s;{}\n",
            t->programme, t->material, t->seed, t->warned() ? "warned" : "NOT WARNED",
            t->interval_s, t->stage_readings, t->lead_s(), t->stage_s,
            t->looks[1] ? t->looks[1]->error : NAN, t->fall_s, t->said);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("what is said of an onset before it comes");
  Options o;
  app.add_option("--seeds", o.seeds, "seeds of each subject")->check(CLI::PositiveNumber);
  app.add_option("--from", o.from, "first seed")->check(CLI::PositiveNumber);
  app.add_option("--jobs", o.jobs, "threads")->check(CLI::PositiveNumber);
  app.add_option("--only", o.only, "programmes whose name holds this");
  app.add_option("--list", o.list, "file of subjects");
  app.add_option("--folder", o.folder, "of programmes");
  app.add_flag("--failures", o.failures, "name the tests that failed");
  app.add_flag("--guard", o.guard, "what a guard that hands the load over catches, instead");
  CLI11_PARSE(app, argc, argv);
  try {
    return run(o);
  } catch (const lab::BadInput& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 2;
  }
}
