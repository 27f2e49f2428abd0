// SPDX-License-Identifier: GPL-3.0-or-later
// bench_probes: time of one stress probe of each law, and of a whole bifurcation domain.
//
// A probe is one direction of the circle at a loaded state (p′ = 100 kPa, η = 0.5) that is made
// ready once, as for a grid of states: direction, strain, W₂ and its norms. The yardsticks are one
// solution of a 2 × 2 and of a 6 × 6 system in the same run. A domain is 200 × 200 states with 360
// directions each, on one thread and on two.
#include <fmt/format.h>

#include <cstdio>
#include <numeric>

#include "bench/point/yardstick.hpp"
#include "lab/materials/material_library.hpp"
#include "sim/stability/domain_criteria.hpp"
#include "sim/stability/domain_run.hpp"

using namespace triax;

namespace {

struct Subject {
  const char* set;
  double void_ratio;
};
constexpr Subject kSubjects[] = {{"elastic/Hostun-loose", 1.0},
                                 {"mohr_coulomb/Hostun-loose", 1.0},
                                 {"drucker_prager/Hostun-loose", 1.0},
                                 {"cam_clay/Hostun-like", 1.0},
                                 {"hypoplastic/HG99", 1.0},
                                 {"hypoplastic/S28-MT-IGS", 1.0},
                                 {"sanisand/S28-general", 1.0},
                                 {"norsand/S28-MT-drained", 1.0},
                                 {"inl2/S28-general", 1.0},
                                 {"octolinear/S28-general", 1.0}};

struct Yardsticks {
  double small_ns = 0, large_ns = 0;
};

template <class Space>
void time_probe(const Subject& subject, const char* plane, const sim::Law<Space>* law,
                const Yardsticks& yardsticks) {
  constexpr double kMean = 100e3, kRatio = 0.5;
  constexpr int kDirections = 360, kTurns = 100;
  if (law == nullptr) return;
  const auto state =
      law->start(sim::domain_stress<Space>(kMean, kRatio * kMean), subject.void_ratio);
  if (const auto objection = law->objection(state)) {
    fmt::print("{:<28}{:<14}{}\n", subject.set, plane, *objection);
    return;
  }
  const auto prober = sim::make_prober(
      std::make_shared<const sim::IncrementalResponse<Space>>(*law, state), sim::ProbeKind::stress);
  double sink = 0;
  const double seconds = bench::least_seconds(9, [&] {
    for (int i = 0; i < kTurns * kDirections; ++i)
      sink += prober(2 * std::numbers::pi * i / kDirections).normalised;
  });
  volatile double kept = sink;
  static_cast<void>(kept);
  const double ns = seconds * 1e9 / (kTurns * kDirections);
  fmt::print("{:<28}{:<14}{:>11}{:>19}{:>13}{:>13}\n", subject.set, plane, bench::timed(ns, 0),
             bench::timed(1e3 / ns, 1), bench::timed(ns / yardsticks.small_ns, 1),
             bench::timed(ns / yardsticks.large_ns, 2));
  std::fflush(stdout);
}

double time_domain(const lab::MaterialSet& set, sim::ProbePlane plane, int threads) {
  const sim::DomainGrid grid{.p_from = 10e3,
                             .p_to = 300e3,
                             .q_from = 0,
                             .q_to = 390e3,
                             .void_ratio = 1.086,
                             .plane = plane};
  if (bench::only_labels) return 1;
  std::vector<int> columns(static_cast<std::size_t>(grid.columns));
  std::iota(columns.begin(), columns.end(), 0);
  return bench::least_seconds(3, [&] {
    sim::run_domain(grid, columns,
                    [&] {
                      sim::DomainWorker worker{lab::made_anew(set), {}};
                      worker.criteria = sim::domain_criteria(worker.material, grid);
                      return worker;
                    },
                    {.threads = threads, .progress = {}});
  });
}

void domain(const char* name, const char* plane_name, sim::ProbePlane plane) {
  const auto set = lab::find_material(name);
  const double one = time_domain(set, plane, 1), two = time_domain(set, plane, 2);
  fmt::print("{:<28}{:<14}{:>13}{:>16}{:>14}\n", name, plane_name, bench::timed(one, 2),
             bench::timed(two, 2), bench::timed(one / two, 2));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  bench::take_labels(argc, argv);
  const Yardsticks yardsticks{bench::solution_ns<2>(), bench::solution_ns<6>()};
  fmt::print("one solution of a system (LU, partial pivoting): 2 x 2 {} ns, 6 x 6 {} ns\n\n",
             bench::timed(yardsticks.small_ns, 1), bench::timed(yardsticks.large_ns, 0));
  fmt::print("{:<28}{:<14}{:>11}{:>19}{:>13}{:>13}\n", "law", "plane", "a probe, ns",
             "million a second", "over 2 x 2", "over 6 x 6");
  for (const Subject& subject : kSubjects) {
    const auto set = lab::find_material(subject.set);
    time_probe(subject, "axisymmetric", set.material.axisymmetric.get(), yardsticks);
    time_probe(subject, "plane-strain", set.material.tensor.get(), yardsticks);
  }
  fmt::print("\n{:<28}{:<14}{:>13}{:>16}{:>14}\n", "domain of 200 x 200 states", "plane",
             "one thread, s", "two threads, s", "times faster");
  for (const char* name : {"inl2/S28-general", "octolinear/S28-general", "sanisand/S28-general"}) {
    domain(name, "axisymmetric", sim::ProbePlane::axisymmetric);
    domain(name, "plane-strain", sim::ProbePlane::plane_strain);
  }
}
