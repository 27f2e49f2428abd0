// SPDX-License-Identifier: GPL-3.0-or-later
// bench_warning: what is said of an onset before it comes, over simulated tests, in memory.
//
// What the columns are: alarm_table.hpp. With --guard: guard_trial.hpp. Without, the end code is 1
// where a bound is not held.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "bench/detection/subjects.hpp"
#include "bench/warning/alarm_table.hpp"
#include "bench/warning/alarm_trial.hpp"
#include "bench/warning/guard_trial.hpp"
#include "bench/warning/limit_table.hpp"
#include "bench/warning/simulated_before.hpp"
#include "bench/warning/worst.hpp"
#include "lab/base/bad_input.hpp"

using namespace triax;

namespace {

struct Options {
  int seeds = 46, from = 1;
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::string only, list = "bench/warning/programmes.txt", folder = "samples/programmes";
  bool failures = false, guard = false;
  std::string worst;
};

/// of(0), of(1), ... of(count − 1), several at a time.
void for_all(std::size_t count, int jobs, const std::function<void(std::size_t)>& of) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) of(i);
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < jobs; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
}

/// Prints the error of a trial that failed, and leaves it out.
template <class Of>
void guarded(const bench::Subject& subject, std::uint64_t seed, const Of& of) {
  static std::mutex mutex;
  try {
    of();
  } catch (const std::exception& e) {
    const std::lock_guard lock(mutex);
    fmt::print(stderr, "{} seed {}: {}\n", subject.programme.name, seed, e.what());
  }
}

/// What the `count` tests after it in the row say, the first after the last.
template <class Test>
lab::EarlierTests earlier_of(const std::vector<Test>& row, std::size_t i, std::size_t count) {
  lab::EarlierTests earlier;
  for (std::size_t j = 1; j <= count && j < row.size(); ++j)
    if (const auto& said = row[(i + j) % row.size()].earlier) earlier.add(*said);
  return earlier;
}

lab::EarlierTests earlier_of(const bench::SimulatedBefore& before) {
  lab::EarlierTests earlier;
  if (before.said) earlier.add(*before.said);
  return earlier;
}

struct All {
  /// Seed by seed, in the order of the subjects: alone, with two tests, with a simulation.
  std::vector<bench::AlarmTrial> alone, with_two, by_law;
  std::vector<bench::LimitTrial> limits;
};

/// All seeds of one subject.
void run_subject(const bench::Subject& subject, std::size_t place, std::size_t subjects,
                 const Options& o, All& all) {
  const auto seeds = static_cast<std::size_t>(o.seeds);
  const auto seed = [&](std::size_t i) { return static_cast<std::uint64_t>(o.from) + i; };
  std::vector<bench::AlarmTest> row(seeds);
  for_all(seeds, o.jobs, [&](std::size_t i) {
    guarded(subject, seed(i), [&] { row[i] = bench::run_alarm_test(subject, seed(i)); });
  });
  std::vector<std::optional<bench::LimitTrial>> limits(seeds);
  for_all(seeds, o.jobs, [&](std::size_t i) {
    const bench::AlarmTest& test = row[i];
    if (test.trial.programme.empty()) return;
    const std::size_t at = i * subjects + place;
    all.alone[at] = test.trial;
    all.with_two[at] = bench::heard_again(test, earlier_of(row, i, 2));
    bench::SimulatedBefore before;
    guarded(subject, seed(i), [&] { before = bench::simulated_before(subject, seed(i)); });
    all.by_law[at] = bench::heard_again(test, earlier_of(before));
    if (!test.truth || !test.trial.comparable()) return;
    bench::Hindsight hindsight(test);
    bench::LimitTrial& limit = limits[i].emplace();
    limit.alone = test.trial;
    limit.one = bench::heard_again(test, earlier_of(row, i, 1), {hindsight.listener()});
    limit.two = all.with_two[at];
    limit.by_law = all.by_law[at];
    limit.members = hindsight.members();
    limit.law = before.eta;
  });
  for (auto& limit : limits)
    if (limit) all.limits.push_back(std::move(*limit));
}

void run_guards(const std::vector<bench::Subject>& subjects, const Options& o) {
  std::vector<bench::GuardTrial> alone, with_two, by_law;
  for (const bench::Subject& subject : subjects) {
    std::vector<bench::GuardTrial> row(static_cast<std::size_t>(o.seeds)), knowing, foreknowing;
    const auto seed = [&](std::size_t i) { return static_cast<std::uint64_t>(o.from) + i; };
    for_all(row.size(), o.jobs, [&](std::size_t i) {
      guarded(subject, seed(i), [&] { row[i] = bench::run_guard_trial(subject, seed(i)); });
    });
    knowing = foreknowing = row;
    for_all(row.size(), o.jobs, [&](std::size_t i) {
      if (row[i].programme.empty()) return;
      guarded(subject, seed(i),
              [&] { bench::run_guarded(subject, earlier_of(row, i, 2), knowing[i]); });
      guarded(subject, seed(i), [&] {
        const auto before = bench::simulated_before(subject, seed(i));
        bench::run_guarded(subject, earlier_of(before), foreknowing[i]);
      });
    });
    alone.insert(alone.end(), row.begin(), row.end());
    with_two.insert(with_two.end(), knowing.begin(), knowing.end());
    by_law.insert(by_law.end(), foreknowing.begin(), foreknowing.end());
  }
  bench::print_guard_trials("The guard alone", alone, o.failures);
  bench::print_guard_trials("The guard with two earlier tests", with_two, o.failures);
  bench::print_guard_trials("The guard with a simulation by its law", by_law, o.failures);
}

int run(const Options& o) {
  auto subjects = bench::read_subjects(o.list, o.folder);
  if (!o.only.empty())
    std::erase_if(subjects, [&](const auto& s) {
      return s.programme.name.find(o.only) == std::string::npos;
    });
  if (o.guard) {
    run_guards(subjects, o);
    return 0;
  }
  const std::size_t count = subjects.size() * static_cast<std::size_t>(o.seeds);
  All all{.alone = std::vector<bench::AlarmTrial>(count),
          .with_two = std::vector<bench::AlarmTrial>(count),
          .by_law = std::vector<bench::AlarmTrial>(count),
          .limits = {}};
  for (std::size_t place = 0; place < subjects.size(); ++place)
    run_subject(subjects[place], place, subjects.size(), o, all);
  const bool held = bench::print_alarm_trials("The alarm alone", all.alone, o.failures);
  fmt::print("\n");
  const bool with_two =
      bench::print_alarm_trials("The alarm with two earlier tests", all.with_two, o.failures);
  fmt::print("\n");
  const bool by_law =
      bench::print_alarm_trials("The alarm with a simulation by its law", all.by_law, o.failures);
  bench::print_limits(all.limits);
  if (!o.worst.empty()) bench::write_worst(all.alone, subjects, o.worst);
  return held && with_two && by_law ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("what is said of an onset before it comes");
  Options o;
  app.option_defaults()->take_last();  // run.sh gives some before its own
  app.add_option("--seeds", o.seeds, "seeds of each subject")->check(CLI::PositiveNumber);
  app.add_option("--from", o.from, "first seed")->check(CLI::PositiveNumber);
  app.add_option("--jobs", o.jobs, "threads")->check(CLI::PositiveNumber);
  app.add_option("--only", o.only, "programmes whose name holds this");
  app.add_option("--list", o.list, "file of subjects");
  app.add_option("--folder", o.folder, "of programmes");
  app.add_flag("--failures", o.failures, "name the tests that failed");
  app.add_option("--worst", o.worst, "folder for records of the worst failures")
      ->check(CLI::ExistingDirectory);
  app.add_flag("--guard", o.guard, "what a guard that hands the load over catches, instead");
  CLI11_PARSE(app, argc, argv);
  try {
    return run(o);
  } catch (const lab::BadInput& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 2;
  }
}
