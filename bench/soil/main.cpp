// SPDX-License-Identifier: GPL-3.0-or-later
// bench_soil: how often the 95 % intervals of `triax soil` hold the truth over virtual campaigns,
// and how often a spoilt test is named. The end code is 1 where a share is out of 93 to 97 % by
// more than its number of campaigns explains.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>

#include "bench/soil/campaign.hpp"
#include "bench/soil/coverage.hpp"
#include "lab/base/statistics.hpp"

using namespace triax;

namespace {

struct Options {
  int campaigns = 1000, spoilt = 300, from = 1, tell = 0;
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
};

struct Named {
  int named = 0, all = 0;
  double could_be = 0;  ///< limit.hpp
};

struct Results {
  bench::Counts all;
  std::map<std::string, bench::Counts> by_class;
  std::map<std::string, Named> spoilt, spoilt_by_drainage, spoilt_by_size;  ///< and by kind
  int clean = 0, wrongly_named = 0, tests = 0, without = 0;
};

class Bench {
 public:
  explicit Bench(const Options& o) : o_(o), classes_(bench::instrument_classes()) {}

  Results run() {
    std::vector<std::thread> threads;
    for (int i = 1; i < o_.jobs; ++i) threads.emplace_back([this] { work(); });
    work();
    for (auto& thread : threads) thread.join();
    return std::move(results_);
  }

 private:
  void work() {
    for (int i = next_++; i < o_.campaigns + o_.spoilt; i = next_++) one(i);
  }

  void one(int i) {
    const auto seed = static_cast<std::uint64_t>(o_.from + i);
    const auto sand = static_cast<bench::Sand>(i % bench::kSands);
    const auto& of = classes_[static_cast<std::size_t>(i / bench::kSands) % classes_.size()];
    const bool spoil = i >= o_.campaigns;
    const auto kind = spoil ? static_cast<bench::Spoilt>(1 + (i / 12) % (bench::kSpoilt - 1))
                            : bench::Spoilt::none;
    const auto campaign = bench::make_campaign(seed, sand, of, kind);
    const auto soil = study::study_soil(campaign.tests, "virtual");
    const std::lock_guard lock(guard_);
    spoil ? note_spoilt(campaign, soil) : note_clean(campaign, soil, seed);
  }

  void note_clean(const bench::Campaign& c, const study::Soil& soil, std::uint64_t seed) {
    ++results_.clean;
    results_.tests += static_cast<int>(c.tests.size());
    results_.wrongly_named +=
        std::ranges::any_of(soil.tests, [](const auto& t) { return t.used && !t.reason.empty(); });
    for (const auto& one : bench::covered(c, soil)) {
      results_.all[one.what].add(one);
      results_.by_class[c.instruments][one.what].add(one);
      if (!one.held && o_.tell > 0)
        fmt::print("seed {} {} {} {} tests: {} {:+.4f} beyond {:.4f}\n", seed, to_string(c.sand),
                   c.instruments, c.tests.size(), one.what, one.error, one.half_width);
    }
  }

  void note_spoilt(const bench::Campaign& c, const study::Soil& soil) {
    if (c.sand == bench::Sand::mohr_coulomb && c.spoilt == bench::Spoilt::void_ratio) return;
    const auto n = c.tests.size();
    const bool named = bench::names(soil, c.spoilt_test);
    const auto note = [&](std::map<std::string, Named>& in, std::string_view of) {
      auto& one = in[fmt::format("{}, {}", to_string(c.spoilt), of)];
      ++one.all;
      one.named += named;
      one.could_be += c.could_be_named;
    };
    note(results_.spoilt, n < 6 ? "3 to 5 tests" : n < 10 ? "6 to 9 tests" : "10 to 20 tests");
    note(results_.spoilt_by_drainage, c.spoilt_drained ? "drained" : "undrained");
    const double size = c.spoilt_deviations;
    note(results_.spoilt_by_size, size < 4    ? "less than 4 deviations"
                                  : size < 10 ? "4 to 10 deviations"
                                              : "more than 10 deviations");
    if (!named && o_.tell > 0)
      fmt::print("{} of {} {} tests, {} not named: {}\n", c.spoilt_test, n, to_string(c.sand),
                 to_string(c.spoilt), c.spoilt_drained ? "drained" : "undrained");
  }

  Options o_;
  std::vector<bench::InstrumentClass> classes_;
  std::atomic<int> next_ = 0;
  std::mutex guard_;
  Results results_;
};

/// An interval of 95 % has to hold the truth as often as this.
constexpr double kLeastShare = 0.93, kMostShare = 0.97;
/// What chance may do to one count: as beyond three standard deviations to one side.
constexpr double kByChance = 0.00135;

double probability(int k, int n, double share) {
  return std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) +
                  k * std::log(share) + (n - k) * std::log(1 - share));
}

/// Whether intervals that hold as often as that would hold as few, or as many, of these by chance.
bool plausible(const bench::Count& count) {
  double at_most = 0, at_least = 0;
  for (int k = 0; k <= count.held; ++k) at_most += probability(k, count.all, kLeastShare);
  for (int k = count.held; k <= count.all; ++k) at_least += probability(k, count.all, kMostShare);
  return at_most > kByChance && at_least > kByChance;
}

void print(const std::map<std::string, Named>& spoilt) {
  for (const auto& [what, named] : spoilt)
    fmt::print("{:<58} named {:>4} of {:>4}, {:>5.1f} %; could be {:>5.1f} %\n", what, named.named,
               named.all, 100.0 * named.named / named.all, 100 * named.could_be / named.all);
  fmt::print("\n");
}

bool print(Results r) {
  bool held = true;
  fmt::print("{} campaigns of {} tests in all\n\n", r.clean, r.tests);
  fmt::print("{:<32} {:>9} {:>8} {:>9} {:>10}", "value", "campaigns", "held", "rms error",
             "half width");
  for (const auto& [name, counts] : r.by_class) fmt::print(" {:>9}", name);
  fmt::print("\n");
  for (auto& [what, count] : r.all) {
    fmt::print("{:<32} {:>9} {:>6.1f} % {:>9.4f} {:>10.4f}", what, count.all, 100 * count.share(),
               std::sqrt(count.squares / count.all), lab::median(count.half_widths));
    for (auto& [name, counts] : r.by_class) fmt::print(" {:>7.1f} %", 100 * counts[what].share());
    fmt::print("\n");
    if (plausible(count)) continue;
    held = false;
    fmt::print(stderr, "bench_soil: {}: {} of {} held is not by chance, of 93 to 97 %\n", what,
               count.held, count.all);
  }
  fmt::print("\nodd tests named where none is spoilt: {} of {} campaigns\n\n", r.wrongly_named,
             r.clean);
  print(r.spoilt);
  print(r.spoilt_by_drainage);
  print(r.spoilt_by_size);
  return held;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("intervals of triax soil against what is true of virtual sands");
  Options o;
  app.add_option("--campaigns", o.campaigns)->check(CLI::PositiveNumber);
  app.add_option("--spoilt", o.spoilt)->check(CLI::NonNegativeNumber);
  app.add_option("--from", o.from, "first seed")->check(CLI::PositiveNumber);
  app.add_option("--jobs", o.jobs, "threads")->check(CLI::PositiveNumber);
  app.add_flag("--tell", o.tell, "each value that was missed");
  CLI11_PARSE(app, argc, argv);
  return print(Bench(o).run()) ? 0 : 1;
}
