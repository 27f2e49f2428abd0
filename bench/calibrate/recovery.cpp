// SPDX-License-Identifier: GPL-3.0-or-later
// Calibration of virtual tests: how near the true parameters are, how often intervals hold them,
// how often searches end in one optimum, and how fast.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Option.hpp>
#include <algorithm>
#include <chrono>
#include <ctime>
#include <random>
#include <regex>

#include "bench/calibrate/virtual_tests.hpp"
#include "src/study/calibrate/calibration.hpp"

namespace {

using namespace triax;
using study::Imposed;

struct Options {
  std::string law = "hypoplastic", material;
  int sets = 5, tests = 12, searches = 1, threads = 0;
  double stress_kPa = 0, strain = 0, spread = 0.15;
  std::vector<std::string> free;
  unsigned seed = 1;
  bool verbose = false;
  bool intervals_only = false;
  bool bare = false;
  bool labels = false;
};

/// Of a grid of pressures and densities, drained and undrained in turn.
std::vector<bench::VirtualTest> campaign(int tests, const lab::MaterialSet& set) {
  const double low = set.void_ratio_range ? set.void_ratio_range->low : 0.7;
  const double high = set.void_ratio_range ? set.void_ratio_range->high : 1.0;
  const double pressures[] = {100, 300, 200, 400};
  std::vector<bench::VirtualTest> all;
  for (int k = 0; k < tests; ++k) {
    const double share = 0.15 + 0.6 * ((k * 5) % tests) / std::max(1, tests - 1);
    all.push_back({k % 2 == 0 ? Imposed::drained : Imposed::undrained, pressures[k % 4],
                   low + share * (high - low)});
  }
  return all;
}

/// Other true parameters: each moved by up to `spread` of its range, as long as the law takes them.
lab::MaterialSet moved(const lab::MaterialSet& base, const std::vector<lab::SearchRange>& free,
                       double spread, std::mt19937_64& dice) {
  const study::SearchSpace space(base, free);
  std::uniform_real_distribution<double> by(-spread, spread);
  for (;;) {
    study::Unknowns x = space.start_point();
    for (Eigen::Index i = 0; i < x.size(); ++i) x(i) = std::clamp(x(i) + by(dice), 0.02, 0.98);
    if (!space.possible(x)) continue;
    lab::MaterialSet set = base;
    set.parameters = space.parameters(x);
    set.material = *space.material(x, Imposed::undrained);
    return set;
  }
}

/// Of all threads: what does not depend on what else the machine does.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// With labels # in place of every number that stands by itself.
void told(const std::string& text, bool labels) {
  static const std::regex number(R"(([ (])[-+]?[0-9][0-9.]*(e[-+]?[0-9]+)?)");
  fmt::print("{}", labels ? std::regex_replace(text, number, "$1#") : text);
}

/// The same paths driven by the law itself, on one thread.
void time_bare(const lab::MaterialSet& base, const std::vector<study::MeasuredPath>& paths,
               const char* what, int knots, double tolerance, bool labels) {
  std::vector<study::MeasuredPath> thin;
  for (const auto& path : paths) thin.push_back(study::thinned(path, knots));
  int runs = 0;
  const double start = processor_seconds();
  double seconds = 0;
  while (runs == 0 || (seconds < 2 && !labels)) {
    for (const auto& path : thin) {
      study::drive(*base.material.axisymmetric, path, {.tolerance = tolerance});
      ++runs;
    }
    seconds = processor_seconds() - start;
  }
  told(
      fmt::format("bare driver, {}: {:.0f} runs a second of one processor\n", what, runs / seconds),
      labels);
}

struct Sums {
  int sets = 0, known = 0, near = 0, unknown = 0, held = 0, agreeing = 0, searches = 0, skipped = 0;
  double worst = 0;
  std::int64_t runs = 0;
  double seconds = 0, processor = 0;
};

void one_set(const Options& o, const lab::MaterialSet& base,
             const std::vector<lab::SearchRange>& free, unsigned seed, Sums& sums) {
  std::mt19937_64 dice(seed);
  const lab::MaterialSet truth = moved(base, free, o.spread, dice);
  study::CalibrationRequest request{.start = base, .free = free};
  for (const auto& test : campaign(o.tests, base)) {
    try {
      request.paths.push_back(bench::virtual_path(truth, test, {o.stress_kPa, o.strain}, dice));
    } catch (const std::invalid_argument&) {
      ++sums.skipped;  // the law refuses this state: no laboratory could have made the test
    }
  }
  if (request.paths.size() < 3) return;
  request.searches = o.searches;
  request.seed = seed;
  request.threads = o.threads;
  request.left_out = false;
  if (o.bare) {
    time_bare(truth, request.paths, "global search", 20, 1e-4, o.labels);
    time_bare(truth, request.paths, "least squares", 60, 1e-7, o.labels);
  }
  const auto before = std::chrono::steady_clock::now();
  const double processor_before = processor_seconds();
  study::Calibration c;
  if (o.intervals_only) {  // from the truth downhill: for coverage, where the optimum is not in
                           // doubt
    request.start = truth;
    const study::SearchSpace space(truth, free);
    const study::Misfit fine(space, request.paths, o.threads,
                             {.tolerance = 1e-7, .step_limit = 4000});
    const auto best = study::least_squares(fine, space.start_point(), 30, [] { return true; });
    const auto sure = study::uncertainty_at(fine, best.x);
    c.parameters = sure.parameters;
    c.cost = best.sum / fine.series();
    c.runs = fine.runs();
    c.degrees_of_freedom = sure.degrees_of_freedom;
  } else {
    c = study::calibrate(request);
  }
  sums.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  sums.processor += processor_seconds() - processor_before;
  sums.runs += c.runs;
  ++sums.sets;
  sums.agreeing += c.ended_at_best;
  sums.searches += c.searches;
  for (std::size_t i = 0; i < free.size(); ++i) {
    const auto& p = c.parameters[i];
    const double true_value = *study::value_of(truth, p.key);
    if (!p.determined) {
      ++sums.unknown;
      continue;
    }
    ++sums.known;
    const double off = std::abs(p.value - true_value) / std::max(std::abs(true_value), 1e-9);
    sums.near += off <= 0.01;
    sums.worst = std::max(sums.worst, off);
    sums.held += p.low <= true_value && true_value <= p.high;
    if (o.verbose)
      fmt::print("  {:30} true {:12.6g} found {:12.6g} ± {:10.4g} [{:.6g}, {:.6g}]{}\n", p.key,
                 true_value, p.value, p.error, p.low, p.high,
                 p.low <= true_value && true_value <= p.high ? "" : " MISSED");
  }
  if (o.verbose)
    fmt::print("  cost {:.3g}, {} of {} searches there, dof {:.0f}\n", c.cost, c.ended_at_best,
               c.searches, c.degrees_of_freedom);
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  CLI::App app("calibration of virtual tests with known parameters");
  app.add_option("--law", o.law);
  app.add_option("--material", o.material);
  app.add_option("--sets", o.sets);
  app.add_option("--tests", o.tests);
  app.add_option("--searches", o.searches);
  app.add_option("--threads", o.threads);
  app.add_option("--stress-noise-kPa", o.stress_kPa);
  app.add_option("--strain-noise", o.strain);
  app.add_option("--spread", o.spread);
  app.add_option("--seed", o.seed);
  app.add_option("--free", o.free)->delimiter(',');
  app.add_flag("--intervals-only", o.intervals_only);
  app.add_flag("--bare", o.bare, "also time the driver alone, at the tolerance of the searches");
  app.add_flag("--verbose", o.verbose);
  app.add_flag("--labels", o.labels, "one small set from the truth, # in place of the numbers");
  CLI11_PARSE(app, argc, argv);
  if (o.labels) {
    o.sets = 1;
    o.tests = 4;
    o.intervals_only = true;
  }
  if (o.material.empty())
    o.material = o.law == "cam_clay"      ? "cam_clay/check"
                 : o.law == "hypoplastic" ? "hypoplastic/Hochstetten-HG99"
                 : o.law == "sanisand"    ? "sanisand/Toyoura-DM04"
                 : o.law == "norsand"     ? "norsand/S28-true-state"
                                          : "mohr_coulomb/Hostun-dense";
  const lab::MaterialSet base = lab::find_material(o.material);
  auto free = lab::shipped_search(o.law);
  if (!o.free.empty())
    std::erase_if(free,
                  [&](const auto& r) { return std::ranges::find(o.free, r.key) == o.free.end(); });
  Sums sums;
  for (int k = 0; k < o.sets; ++k) one_set(o, base, free, o.seed + static_cast<unsigned>(k), sums);
  told(
      fmt::format(
          "{}: {} sets of {} tests, noise {:g} kPa and {:g}: {} parameters determined, {} not; "
          "within 1 % {} ({:.1f} %), worst {:.3g} %; intervals hold {} ({:.1f} %); searches at the "
          "best {} of {}; {} runs of the driver in {:.1f} s, {:.1f} s of processors: {:.0f} runs a "
          "second of "
          "one\n",
          base.name, sums.sets, o.tests, o.stress_kPa, o.strain, sums.known, sums.unknown,
          sums.near, 100.0 * sums.near / std::max(1, sums.known), 100 * sums.worst, sums.held,
          100.0 * sums.held / std::max(1, sums.known), sums.agreeing, sums.searches, sums.runs,
          sums.seconds, sums.processor, static_cast<double>(sums.runs) / sums.processor),
      o.labels);
}
