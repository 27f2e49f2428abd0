// SPDX-License-Identifier: GPL-3.0-or-later
// bench_detection: detection of collapse over thousands of simulated tests, in memory.
//
// Every subject of programmes.txt is run with every seed through noisy instruments, reduction and
// monitor; the naive methods look at the same states. Truth is the instant at which the specimen's
// own second-order work turned negative, which no instrument sees.
//   delay          reading reported as onset − first reading at or after the true instant; its
//                  absolute value is counted
//   noticed after  reading at which the monitor first said so while the test ran − the same first
//                  reading; tests of which it said nothing are counted apart ("never")
// With --kinds: the tests of kinds.hpp instead, where instruments are cheap, readings few, the test
// fast; nothing is bounded.
//   |error of eta| measured eta at the onset reported − true eta at the true instant
// Ends with status 1 if a bound is broken.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <thread>

#include "bench/detection/kinds.hpp"
#include "bench/detection/subjects.hpp"
#include "bench/detection/table.hpp"
#include "bench/detection/tails.hpp"
#include "lab/base/bad_input.hpp"

using namespace triax;

namespace {

struct Options {
  int seeds = 72;  ///< more than 2,000 tests that can be judged
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::uint64_t first_seed = 1;
  bool kinds = false;
  std::string only, csv, list = "bench/detection/programmes.txt", folder = "samples/programmes";
};

/// The line of progress on a terminal, with the time that is left at the pace so far.
class Progress {
 public:
  explicit Progress(std::size_t of) : of_(of) {}
  void show(std::size_t done) const {
    if (!on_terminal_) return;
    const std::chrono::duration<double> taken = Clock::now() - start_;
    const double left = taken.count() * static_cast<double>(of_ - done) / static_cast<double>(done);
    fmt::print(stderr, "\r{} of {} tests, {:.0f} s left\x1b[K", done, of_, left);
    std::fflush(stderr);
  }
  ~Progress() {
    if (on_terminal_) std::fputs("\r\x1b[K", stderr);
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::size_t of_;
  bool on_terminal_ = isatty(STDERR_FILENO) == 1;
  Clock::time_point start_ = Clock::now();
};

/// Each of `subjects` tests with every seed.
template <class Run>
std::vector<bench::TrialResult> run_all(std::size_t subjects, const Options& options,
                                        const Run& run) {
  const auto seeds = static_cast<std::size_t>(options.seeds);
  std::vector<bench::TrialResult> results(subjects * seeds);
  std::atomic<std::size_t> next = 0;
  std::size_t done = 0;
  std::exception_ptr failure;
  std::mutex guard;
  const Progress progress(results.size());
  const auto work = [&] {
    for (std::size_t i = next++; i < results.size(); i = next++) {
      std::exception_ptr error;
      try {
        // Every seed runs through all subjects before the next: what is left is foreseen well.
        results[i] = run(i % subjects, options.first_seed + i / subjects);
      } catch (...) {
        error = std::current_exception();
        next = results.size();
      }
      const std::scoped_lock lock(guard);
      if (error && !failure) failure = error;
      progress.show(++done);
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < options.jobs; ++i) threads.emplace_back(work);
  }
  if (failure) std::rethrow_exception(failure);
  return results;
}

void write_csv(const std::vector<bench::TrialResult>& results, const Options& options) {
  if (options.csv.empty()) return;
  std::ofstream file(options.csv);
  file << bench::csv(results);
  if (!file.flush()) throw lab::WorkFailed(options.csv + ": cannot be written");
}

int run_kinds(const Options& options) {
  std::vector<bench::Kind> kinds;
  for (const bench::Kind& kind : bench::kinds())
    if (fmt::format("{}, {}", kind.name, kind.programme).find(options.only) != std::string::npos)
      kinds.push_back(kind);
  if (kinds.empty()) throw lab::BadInput("--only " + options.only + ": no kind of that name");
  const auto results = run_all(kinds.size(), options, [&](std::size_t i, std::uint64_t seed) {
    return bench::run_kind(kinds[i], seed);
  });
  fmt::print("{}", bench::table_of_kinds(results));
  write_csv(results, options);
  return 0;
}

int run(const Options& options) {
  auto subjects = bench::read_subjects(options.list, options.folder);
  if (!options.only.empty())
    std::erase_if(subjects, [&](const bench::Subject& s) {
      return (s.collapses ? s.programme.type : "controls") != options.only;
    });
  if (subjects.empty())
    throw lab::BadInput("--only " + options.only + ": no programme of that type");
  const auto results = run_all(subjects.size(), options, [&](std::size_t i, std::uint64_t seed) {
    return bench::run_trial(subjects[i], seed);
  });
  fmt::print("{}{}", bench::table(results), bench::tails(results, {}));
  write_csv(results, options);
  const auto faults = bench::broken(results, {}, options.only.empty());
  for (const std::string& fault : faults) fmt::print("not held: {}\n", fault);
  if (faults.empty() && options.only.empty()) fmt::print("all bounds hold\n");
  return faults.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Detection of collapse over many simulated tests, beside naive methods");
  app.add_option("--seeds", options.seeds, "tests of each subject")->check(CLI::PositiveNumber);
  app.add_option("--first-seed", options.first_seed, "number of the first seed");
  app.add_option("--jobs", options.jobs, "threads")->check(CLI::PositiveNumber);
  app.add_option("--only", options.only,
                 "ICU, CSD, CSU, SP or controls; with --kinds the beginning of a kind's name, or "
                 "part of a programme's");
  app.add_flag("--kinds", options.kinds, "onsets that are hard to place, with their intervals");
  app.add_option("--csv", options.csv, "file for one line a test and method");
  app.add_option("--list", options.list, "list of subjects");
  app.add_option("--programmes", options.folder, "folder of the programmes");
  CLI11_PARSE(app, argc, argv);
  try {
    return options.kinds ? run_kinds(options) : run(options);
  } catch (const lab::BadInput& error) {
    fmt::print(stderr, "bench_detection: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_detection: {}\n", error.what());
    return 1;
  }
}
