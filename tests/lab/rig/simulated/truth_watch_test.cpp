// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/truth_watch.hpp"

#include <catch2/catch.hpp>

using namespace triax;

namespace {

/// An axial increment at constant radial stress, of one second.
void set(sim::SpecimenState& state, double p_pa, double q_pa) {
  state.material.stress =
      sim::components(sim::AxisymmetricStress{p_pa + 2 * q_pa / 3, p_pa - q_pa / 3});
}

struct Path {
  lab::TruthWatch watch;
  sim::SpecimenState state;
  double time_s = 0;
  sim::RunAway run_away;

  Path() {
    state.height_m = 0.14;
    set(state, 100e3, 50e3);
  }
  void step(double dq_pa, double strain, bool shear = true) {
    sim::SpecimenStep step;
    step.state = state;
    step.state.run_away = run_away;
    step.state.height_m *= 1 - strain;
    set(step.state, state.material.p() + dq_pa / 3, state.material.q() + dq_pa);
    step.stress_increment.axial = dq_pa;
    step.strain_increment.axial = strain;
    watch.watch(time_s, 1, state, step, shear, 0.14);
    state = step.state;
    time_s += 1;
  }
};

}  // namespace

TEST_CASE("negative work that lasts is the loss of sustainability, at its first instant") {
  Path path;
  for (int i = 0; i < 10; ++i) path.step(10, 1e-5);
  for (int i = 0; i < 9; ++i) path.step(-10, 1e-5);
  CHECK_FALSE(path.watch.truth().lost_sustainability);
  for (int i = 0; i < 5; ++i) path.step(-10, 1e-5);
  const lab::Truth truth = path.watch.truth();
  REQUIRE(truth.lost_sustainability);
  CHECK(*truth.time_s == Approx(10));
  CHECK(*truth.q_pa == Approx(50e3 + 100));
  CHECK(*truth.p_eff_pa == Approx(100e3 + 100.0 / 3));
  CHECK(*truth.axial_strain == Approx(1e-4).epsilon(0.01));
}

TEST_CASE("a short search of the servo is no loss of sustainability") {
  Path path;
  for (int i = 0; i < 100; ++i) {
    path.step(10, 1e-5);
    path.step(-10, 3e-5);
  }
  CHECK_FALSE(path.watch.truth().lost_sustainability);
}

TEST_CASE("elastic unloading and what happens outside shear do not count") {
  Path path;
  for (int i = 0; i < 100; ++i) path.step(-10, -1e-5);
  CHECK_FALSE(path.watch.truth().lost_sustainability);
  for (int i = 0; i < 100; ++i) path.step(-10, 1e-5, false);
  CHECK_FALSE(path.watch.truth().lost_sustainability);
}

TEST_CASE("the swings of a slip show nothing; a run-away that went far does, arrested or not") {
  const auto run_away_of = [](double strain) {
    Path path;
    for (int i = 0; i < 10; ++i) path.step(10, 1e-5);
    path.run_away = {.under_way = true, .count = 1, .start_height_m = path.state.height_m};
    for (int i = 0; i < 20; ++i) path.step(-10, strain / 20);
    path.run_away.under_way = false;
    path.run_away.end = sim::RunAway::End::arrested;
    path.step(10, 1e-5);
    for (int i = 0; i < 10; ++i) path.step(10, 1e-5);
    return path;
  };
  const Path slip = run_away_of(0.008);
  CHECK_FALSE(slip.watch.truth().lost_sustainability);
  const lab::Truth fall = run_away_of(0.03).watch.truth();
  REQUIRE(fall.lost_sustainability);
  CHECK(*fall.time_s == Approx(10).margin(0.6));
  // The watch goes on after a slip.
  Path after = slip;
  const double from_s = after.time_s;
  for (int i = 0; i < 20; ++i) after.step(-10, 1e-5);
  REQUIRE(after.watch.truth().lost_sustainability);
  CHECK(*after.watch.truth().time_s == Approx(from_s).margin(1));
}
