// SPDX-License-Identifier: GPL-3.0-or-later
// bench_soil: how often the 95 % intervals of `triax soil` hold the truth over virtual campaigns,
// and how often a spoilt test is named. The end code is 1 where a share differs from 95 % by more
// than its number of campaigns explains.
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
};

struct Results {
  bench::Counts all;
  std::map<std::string, bench::Counts> by_class;
  std::map<std::string, Named> spoilt;  ///< by kind and number of tests
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
    auto& named = results_.spoilt[fmt::format("{}, {} tests", to_string(c.spoilt),
                                              n < 6    ? "3 to 5"
                                              : n < 10 ? "6 to 9"
                                                       : "10 to 20")];
    ++named.all;
    named.named += bench::names(soil, c.spoilt_test);
  }

  Options o_;
  std::vector<bench::InstrumentClass> classes_;
  std::atomic<int> next_ = 0;
  std::mutex guard_;
  Results results_;
};

constexpr double kConfidence = 0.95;
/// What chance may do to one count: as beyond three standard deviations to one side.
constexpr double kByChance = 0.00135;

/// Whether intervals that hold 95 % would hold as few, or as many, of these by chance.
bool plausible(const bench::Count& count) {
  double at_most = 0, at_least = 0;
  for (int k = 0; k <= count.all; ++k) {
    const double p =
        std::exp(std::lgamma(count.all + 1) - std::lgamma(k + 1) - std::lgamma(count.all - k + 1) +
                 k * std::log(kConfidence) + (count.all - k) * std::log(1 - kConfidence));
    if (k <= count.held) at_most += p;
    if (k >= count.held) at_least += p;
  }
  return at_most > kByChance && at_least > kByChance;
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
    fmt::print(stderr, "bench_soil: {}: {} of {} held is not by chance, of intervals of 95 %\n",
               what, count.held, count.all);
  }
  fmt::print("\nodd tests named where none is spoilt: {} of {} campaigns\n\n", r.wrongly_named,
             r.clean);
  for (const auto& [what, named] : r.spoilt)
    fmt::print("{:<52} named {:>4} of {:>4}\n", what, named.named, named.all);
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
