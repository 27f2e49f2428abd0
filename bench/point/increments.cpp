// SPDX-License-Identifier: GPL-3.0-or-later
// bench_increments: time of one increment of each law, against one solution of a 6 x 6 system.
//
// Undrained compression of 10 % in equal increments, each one call of the driver with a state in
// and a state out, as a host program would do it. The number of increments and the tolerance are
// the cheapest of a list with which the whole path keeps its relative error of stress below 1e-6,
// judged against the same path with a tolerance of 1e-13.
#include <fmt/format.h>
#include <algorithm>
#include <cstdio>
#include <optional>

#include "bench/point/yardstick.hpp"
#include "lab/materials/material_library.hpp"
#include "sim/point/point_driver.hpp"

using namespace triax;

namespace {

constexpr double kStrain = 0.10;
constexpr double kLargestError = 1e-6;
constexpr int kRounds = 5;

struct Subject {
  const char* set;
  double void_ratio, p_pa;
};
// A medium dense state that neither liquefies nor leaves the range of the set.
constexpr Subject kSubjects[] = {{"elastic/Hostun-loose", 0.85, 100e3},
                                 {"mohr_coulomb/Hostun-loose", 0.85, 100e3},
                                 {"drucker_prager/Hostun-loose", 0.85, 100e3},
                                 {"cam_clay/Hostun-like", 0.85, 100e3},
                                 {"hypoplastic/HG99", 0.85, 100e3},
                                 {"hypoplastic/S28-MT-IGS", 0.95, 100e3},
                                 {"sanisand/S28-general", 0.75, 100e3},
                                 {"norsand/S28-MT", 0.90, 100e3},
                                 {"inl2/S28-general", 0.85, 100e3},
                                 {"octolinear/S28-general", 0.85, 100e3}};

template <class Space>
std::optional<sim::Vector<Space>> run(const sim::Law<Space>& law,
                                      const sim::PointState<Space>& start, int increments,
                                      double tolerance) {
  const sim::PointTolerance settings{.relative = tolerance};
  const auto control = sim::MixedControl<Space>::strain_path(kStrain / increments);
  sim::PointDriver<Space> driver(law, start, control, settings);
  auto state = start;
  for (int i = 0; i < increments; ++i) {
    auto step = driver.advance(state);
    if (step.outcome != sim::StepOutcome::accepted) return std::nullopt;
    state = step.state;
  }
  return state.stress;
}

struct Best {
  double ns = 0, tolerance = 0;
  int increments = 0;
};

template <class Space>
std::optional<Best> cheapest(const sim::Law<Space>& law, const Subject& subject) {
  const auto start = law.isotropic(subject.p_pa, subject.void_ratio);
  if (law.objection(start)) return std::nullopt;
  const auto exact = run(law, start, 100, 1e-13);
  if (!exact) return std::nullopt;
  std::optional<Best> best;
  for (const int increments : {5000, 10000, 20000})
    for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-8}) {
      const auto found = run(law, start, increments, tolerance);
      if (!found) continue;
      const double error = (*found - *exact).norm() / exact->norm();
      if (error > kLargestError) continue;
      const double seconds =
          bench::least_thread_seconds(5, [&] { run(law, start, increments, tolerance); });
      const double ns = seconds * 1e9 / increments;
      if (!best || ns < best->ns) best = Best{ns, tolerance, increments};
    }
  return best;
}

template <class Space>
void print(const std::string& set, const char* space, const sim::Law<Space>* law,
           const Subject& subject) {
  const auto best = law ? cheapest(*law, subject) : std::nullopt;
  if (!best) {
    fmt::print("{:<28}{:<14}no path of this accuracy\n", set, space);
    return;
  }
  // In turn, the least of each: what else runs on the machine comes and goes, the clock changes.
  const auto start = law->isotropic(subject.p_pa, subject.void_ratio);
  double ns = best->ns, yardstick = bench::solution_ns();
  for (int round = 0; round < (bench::only_labels ? 0 : kRounds); ++round) {
    const double seconds = bench::least_thread_seconds(
        5, [&] { run(*law, start, best->increments, best->tolerance); });
    ns = std::min(ns, seconds * 1e9 / best->increments);
    yardstick = std::min(yardstick, bench::solution_ns());
  }
  fmt::print("{:<28}{:<14}{:>16}{:>17}{:>7}\n", set, space, bench::timed(ns, 0),
             bench::timed(yardstick, 0), bench::timed(ns / yardstick, 2));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  bench::take_labels(argc, argv);
  fmt::print("{:<28}{:<14}{:>16}{:>17}{:>7}\n", "law", "space", "an increment, ns",
             "a solution, ns", "ratio");
  for (const Subject& subject : kSubjects) {
    const auto set = lab::find_material(subject.set);
    print(set.name, "axisymmetric", set.material.axisymmetric.get(), subject);
    print(set.name, "tensor", set.material.tensor.get(), subject);
  }
}
