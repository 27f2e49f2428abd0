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
#include <mutex>
#include <thread>
#include <vector>

#include "bench/detection/subjects.hpp"
#include "bench/warning/alarm_table.hpp"
#include "bench/warning/alarm_trial.hpp"
#include "bench/warning/guard_trial.hpp"
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
  const bool held = bench::print_alarm_trials(trials, o.failures);
  if (!o.worst.empty()) bench::write_worst(trials, subjects, o.worst);
  return held ? 0 : 1;
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
