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

#include "bench/calibrate/held_share.hpp"
#include "bench/calibrate/virtual_tests.hpp"
#include "lab/base/statistics.hpp"
#include "src/study/calibrate/calibration.hpp"
#include "src/study/calibrate/left_out.hpp"

namespace {

using namespace triax;
using study::Imposed;

struct Options {
  std::string law = "hypoplastic", material, library = "build/release/tests/libumat_fixture.so";
  int sets = 5, tests = 12, searches = 1, threads = 0;
  double stress_kPa = 0, strain = 0, spread = 0.15, void_ratio = 0;
  bool left_out = false;
  std::vector<std::string> free;
  unsigned seed = 1;
  bool verbose = false;
  bool intervals_only = false;
  bool bare = false;
  bool labels = false;

  bool noisy() const { return stress_kPa > 0 || strain > 0; }
};

/// Of a grid of pressures and densities, drained and undrained in turn; `loose`: the undrained ones
/// in the loosest part of the range, where soils collapse.
std::vector<bench::VirtualTest> campaign(int tests, const lab::MaterialSet& set,
                                         bool loose = false) {
  const double low = set.void_ratio_range ? set.void_ratio_range->low : 0.7;
  const double high = set.void_ratio_range ? set.void_ratio_range->high : 1.0;
  const double pressures[] = {100, 300, 200, 400};
  std::vector<bench::VirtualTest> all;
  for (int k = 0; k < tests; ++k) {
    double share = 0.15 + 0.6 * ((k * 5) % tests) / std::max(1, tests - 1);
    if (loose && k % 2 == 1) share = 0.75 + 0.2 * ((k * 5) % tests) / std::max(1, tests - 1);
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

/// Each test that collapsed, predicted from the others: what was measured is the true ratio with an
/// error of a half percent, and each void ratio has the error that `o` says, which nobody tells.
struct Predicted {
  int held = 0, all = 0, none = 0;
  double squares = 0;
  std::vector<double> half_widths;
};

void predict(const Options& o, const lab::MaterialSet& base,
             const std::vector<lab::SearchRange>& free, unsigned seed, Predicted& sums) {
  constexpr double kOnsetError = 0.005;
  std::mt19937_64 dice(seed);
  std::normal_distribution<double> normal;
  const lab::MaterialSet truth = moved(base, free, o.spread, dice);
  std::vector<study::MeasuredPath> paths;
  for (const auto& test : campaign(o.tests, base, true)) {
    try {
      paths.push_back(bench::virtual_path(truth, test, {o.stress_kPa, o.strain}, dice));
    } catch (const std::invalid_argument&) {
      continue;  // the law refuses this state
    }
    paths.back().void_ratio += o.void_ratio * normal(dice);
    if (auto& onset = paths.back().onset_eta) {
      paths.back().onset_eta_error = kOnsetError * std::abs(*onset);
      *onset += paths.back().onset_eta_error * normal(dice);
    }
  }
  if (paths.size() < 3) return;
  const study::SearchSpace space(truth, free);
  const study::Misfit fine(space, paths, o.threads, {.tolerance = 1e-7, .step_limit = 4000});
  const auto best = study::least_squares(fine, space.start_point(), 30, [] { return true; });
  for (const auto& one : study::predict_left_out(fine, best.x, 0, [](double) { return true; })) {
    if (!one.predicted) {
      ++sums.none;
      continue;
    }
    ++sums.all;
    sums.held += one.holds();
    const double error = *one.predicted - one.measured;
    sums.squares += error * error;
    sums.half_widths.push_back((one.high - one.low) / 2);
    if (o.verbose)
      fmt::print("  seed {} {}: measured {:.4f}, predicted {:.4f} [{:.4f}, {:.4f}]{}\n", seed,
                 one.test, one.measured, *one.predicted, one.low, one.high,
                 one.holds() ? "" : " MISSED");
  }
}

void print_predictions(const Options& o, const lab::MaterialSet& base,
                       const std::vector<lab::SearchRange>& free) {
  Predicted sums;
  for (int k = 0; k < o.sets; ++k) predict(o, base, free, o.seed + static_cast<unsigned>(k), sums);
  const int all = std::max(1, sums.all);
  told(fmt::format("{}: {} sets of {} tests, noise {:g} kPa and {:g}, void ratios {:g} off: {} "
                   "tests predicted from the others, {} not; intervals of 90 % hold {} ({:.1f} %); "
                   "rms error of eta {:.4f}, half width {:.4f}\n",
                   base.name, o.sets, o.tests, o.stress_kPa, o.strain, o.void_ratio, sums.all,
                   sums.none, sums.held, 100.0 * sums.held / all, std::sqrt(sums.squares / all),
                   sums.half_widths.empty() ? 0 : lab::median(sums.half_widths)),
       o.labels);
}

struct Sums {
  int sets = 0, known = 0, near = 0, unknown = 0, agreeing = 0, searches = 0, as_good = 0;
  bench::HeldShare held;
  double worst = 0;
  std::int64_t runs = 0;
  double seconds = 0, processor = 0;
};

/// The searches of the program. Of exact tests one after another until one ends without a misfit:
/// none of the others could end lower.
study::Calibration searched(const Options& o, const study::CalibrationRequest& request) {
  if (o.noisy()) return study::calibrate(request);
  constexpr double kNoMisfit = 1e-6;
  std::vector<study::SearchEnd> ends;
  for (int k = 1; k <= request.searches; ++k) {
    ends.push_back(study::run_searches(request, k, request.searches, {}, [] { return true; })[0]);
    if (ends.back().optima.front().cost < kNoMisfit) break;
  }
  return study::conclude(request, ends, {}, [] { return true; });
}

void one_set(const Options& o, const lab::MaterialSet& base,
             const std::vector<lab::SearchRange>& free, unsigned seed, Sums& sums) {
  std::mt19937_64 dice(seed);
  const lab::MaterialSet truth = moved(base, free, o.spread, dice);
  study::CalibrationRequest request{.start = base, .free = free};
  for (const auto& test : campaign(o.tests, base)) {
    try {
      request.paths.push_back(bench::virtual_path(truth, test, {o.stress_kPa, o.strain}, dice));
    } catch (const std::invalid_argument&) {
      continue;  // the law refuses this state: no laboratory could have made the test
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
  // From the truth downhill: for coverage, where the optimum is not in doubt.
  if (o.intervals_only || o.labels) {
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
    c = searched(o, request);
  }
  sums.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  sums.processor += processor_seconds() - processor_before;
  sums.runs += c.runs;
  ++sums.sets;
  sums.agreeing += c.ended_at_best;
  sums.searches += c.searches;
  sums.as_good += std::max(0, static_cast<int>(c.optima.size()) - 1);
  int known = 0, held = 0;
  for (std::size_t i = 0; i < free.size(); ++i) {
    const auto& p = c.parameters[i];
    const double true_value = *study::value_of(truth, p.key);
    if (!p.determined) {
      ++sums.unknown;
      continue;
    }
    ++known;
    const double off = std::abs(p.value - true_value) / std::max(std::abs(true_value), 1e-9);
    sums.near += off <= 0.01;
    sums.worst = std::max(sums.worst, off);
    held += p.low <= true_value && true_value <= p.high;
    if (o.verbose)
      fmt::print("  {:30} true {:12.6g} found {:12.6g} ± {:10.4g} [{:.6g}, {:.6g}]{}\n", p.key,
                 true_value, p.value, p.error, p.low, p.high,
                 p.low <= true_value && true_value <= p.high ? "" : " MISSED");
  }
  sums.known += known;
  sums.held.add(held, known);
  if (o.verbose)
    fmt::print("  cost {:.3g}, {} of {} searches there, dof {:.0f}\n", c.cost, c.ended_at_best,
               c.searches, c.degrees_of_freedom);
}

/// The cone of the tests' plug-in: elastic, and perfectly plastic with dilatancy N.
lab::MaterialSet cone(const std::string& library, std::vector<lab::SearchRange>& free) {
  lab::MaterialSet set{.name = "umat/cone", .law = sim::find_law("umat")};
  set.parameters.texts = {{"umat", library}, {"name", "CONE"}};
  set.parameters.numbers = {{"state_variables", 12}, {"void_ratio_index", 1}};
  set.parameters.lists["properties"] = {20e3, 12e3, 1.2, 0.3, 5, 0};
  set.material = set.law->make(set.parameters, {});
  free = lab::read_search(R"([search]
"properties.1" = [8000.0, 50000.0]
"properties.2" = [5000.0, 30000.0]
"properties.3" = [0.8, 1.6]
"properties.4" = [0.05, 0.6]
"properties.5" = [1.0, 20.0]
)",
                          "umat");
  return set;
}

/// What came of all sets, on one line; false where it is not what is asked for.
bool summary(const Options& o, const std::string& name, const Sums& sums) {
  const bool all_near = sums.near == sums.known, share_held = sums.held.plausible();
  std::string text = fmt::format(
      "{}: {} sets of {} tests, noise {:g} kPa and {:g}: {} parameters determined, {} not; within "
      "1 % {} ({:.1f} %), worst {:.3g} %",
      name, sums.sets, o.tests, o.stress_kPa, o.strain, sums.known, sums.unknown, sums.near,
      100.0 * sums.near / std::max(1, sums.known), 100 * sums.worst);
  const auto verdict = [&](bool yes) { return yes || o.labels ? "held" : "NOT held"; };
  if (o.noisy())
    text += fmt::format(
        "; intervals hold {} ({:.1f} % with a standard error of {:.1f} % over sets), asked 93 to "
        "97 %: {}",
        sums.held.held(), 100 * sums.held.share(), 100 * sums.held.standard_error(),
        verdict(share_held));
  else
    text += fmt::format(", asked all: {}", verdict(all_near));
  if (!o.intervals_only)
    text += fmt::format("; searches at the best {} of {}, other optima as good {}", sums.agreeing,
                        sums.searches, sums.as_good);
  text += fmt::format(
      "; {} runs of the driver in {:.1f} s, {:.1f} s of processors: {:.0f} runs a second of one\n",
      sums.runs, sums.seconds, sums.processor, static_cast<double>(sums.runs) / sums.processor);
  told(text, o.labels);
  return o.noisy() ? share_held : all_near;
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  CLI::App app("calibration of virtual tests with known parameters");
  app.add_option("--law", o.law);
  app.add_option("--material", o.material);
  app.add_option("--library", o.library, "of the law umat: the plug-in of the tests");
  app.add_option("--sets", o.sets);
  app.add_option("--tests", o.tests);
  app.add_option("--searches", o.searches);
  app.add_option("--threads", o.threads);
  app.add_option("--stress-noise-kPa", o.stress_kPa);
  app.add_option("--strain-noise", o.strain);
  app.add_option("--spread", o.spread);
  app.add_option("--seed", o.seed);
  app.add_option("--free", o.free)->delimiter(',');
  app.add_option("--void-ratio-noise", o.void_ratio);
  app.add_flag("--intervals-only", o.intervals_only);
  app.add_flag("--left-out", o.left_out, "each test predicted from the others");
  app.add_flag("--bare", o.bare, "also time the driver alone, at the tolerance of the searches");
  app.add_flag("--verbose", o.verbose);
  app.add_flag("--labels", o.labels, "one small set from the truth, # in place of the numbers");
  CLI11_PARSE(app, argc, argv);
  if (o.labels) {
    o.sets = 1;
    o.tests = 4;
  }
  if (o.material.empty())
    o.material = o.law == "cam_clay"      ? "cam_clay/check"
                 : o.law == "hypoplastic" ? "hypoplastic/Hochstetten-HG99"
                 : o.law == "sanisand"    ? "sanisand/Toyoura-DM04"
                 : o.law == "norsand"     ? "norsand/S28-true-state"
                                          : "mohr_coulomb/Hostun-dense";
  std::vector<lab::SearchRange> free;
  lab::MaterialSet base;
  if (o.law == "umat") {
    base = cone(o.library, free);
  } else {
    base = lab::find_material(o.material);
    free = lab::shipped_search(o.law);
  }
  if (!o.free.empty())
    std::erase_if(free,
                  [&](const auto& r) { return std::ranges::find(o.free, r.key) == o.free.end(); });
  if (o.left_out) {
    print_predictions(o, base, free);
    return 0;
  }
  Sums sums;
  for (int k = 0; k < o.sets; ++k) one_set(o, base, free, o.seed + static_cast<unsigned>(k), sums);
  const bool asked = summary(o, base.name, sums);
  return asked || o.labels ? 0 : 1;
}
