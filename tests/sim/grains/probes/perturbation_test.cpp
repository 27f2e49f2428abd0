// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/probes/perturbation.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "sim/grains/paths/grain_path.hpp"
#include "sim/grains/state/grain_measures.hpp"
#include "tests/sim/grains/packings.hpp"
#include "tests/sim/grains/specimens.hpp"

using namespace triax::sim;

namespace {

/// The dense specimen part of the way up a path that has no peak there.
const Equilibrium& before_peak() {
  static const Equilibrium state = [] {
    GrainPath path;
    path.kind = GrainPathKind::strain_path;
    path.ratio = 1;
    path.strain_rate_per_s = 0.5;
    path.axial_strain = 0.003;
    return equilibrium_at(follow(test::dense_specimen().state, path).state, 1);
  }();
  return state;
}

Perturbation gentle() {
  Perturbation how;
  how.ratio = 1;
  return how;
}

}  // namespace

TEST_CASE("Perturbation: an equilibrium of a path is at rest with its walls") {
  const Equilibrium& e = before_peak();
  REQUIRE(e.rest.at_rest);
  CHECK(e.path_stress_pa > 1e4);
  CHECK(measure(e.state).unbalanced < 1e-3);
  for (const double rate : e.state.walls.strain_rate_per_s) CHECK(rate == 0);
}

TEST_CASE("Perturbation: an equilibrium before the peak takes a load step and rests again") {
  Perturbation how = gentle();
  how.load_step_pa = 500;
  const PerturbationResult r = perturb(before_peak().state, how);
  REQUIRE(r.end == PerturbationEnd::at_rest);
  CHECK(r.points.back().path_stress_pa ==
        Approx(before_peak().path_stress_pa + 500).margin(how.stress_error_pa));
  CHECK(r.points.front().stress_share == Approx(1));
  CHECK(r.points.back().axial_strain > 0);
  CHECK(r.state.box.volume_m3() == Approx(before_peak().state.box.volume_m3()).epsilon(1e-12));
  CHECK(r.grains_hit == 0);
}

TEST_CASE("Perturbation: energy given to floating grains is what was asked for") {
  Grains grains(before_peak().state);
  grains.stop_motion();
  const std::int64_t floating = measure(grains.state()).floating_grains;
  REQUIRE(floating > 2);
  const std::int64_t hit = give_energy(grains, 1e-6, 0.5, 4);
  CHECK(hit == std::lround(0.5 * static_cast<double>(floating)));
  CHECK(kinetic_energy(grains.state()) == Approx(1e-6));
  Grains same(before_peak().state), other(before_peak().state);
  same.stop_motion();
  other.stop_motion();
  give_energy(same, 1e-6, 0.5, 4);
  give_energy(other, 1e-6, 0.5, 5);
  CHECK(test::same_bits(grains.state(), same.state()));
  CHECK_FALSE(test::same_bits(grains.state(), other.state()));

  Perturbation how = gentle();
  how.kinetic_energy_j = 1e-7;
  const PerturbationResult r = perturb(before_peak().state, how);
  CHECK(r.end == PerturbationEnd::at_rest);
  CHECK(r.most_kinetic_j < 2e-7);
}

TEST_CASE("Perturbation: more than a specimen can carry makes it collapse") {
  Perturbation how = gentle();
  how.load_step_pa = 1e8;
  const PerturbationResult r = perturb(before_peak().state, how);
  CHECK(r.end == PerturbationEnd::collapsed);
  CHECK(r.points.size() <= 400);
}

TEST_CASE("Perturbation: settings out of their ranges are refused") {
  Perturbation how = gentle();
  how.ratio = 0;
  CHECK_THROWS_AS(perturb(before_peak().state, how), std::invalid_argument);
  how = gentle();
  how.kinetic_energy_j = -1;
  CHECK_THROWS_AS(perturb(before_peak().state, how), std::invalid_argument);
  CHECK_THROWS_AS(equilibrium_at(before_peak().state, 0), std::invalid_argument);
}
