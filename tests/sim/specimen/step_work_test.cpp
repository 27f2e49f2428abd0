// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/step_work.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/specimen/specimens.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

struct Path {
  const char* name;
  double cell_rate, velocity, flow;
  bool holds_q;
  Water water;
};

/// Sum of |balance| of the steps over 20 s of a path after 50 s of drained shear, J.
double missed(const Specimen& specimen, const Path& path, double dt_s) {
  SpecimenState state = run(specimen, specimen.start(), moved(2e-6, Water::drained), 0.25, 200);
  SpecimenBoundary b = path.holds_q ? constant_q(state.material.q(), path.cell_rate, path.water)
                                    : moved(path.velocity, path.water);
  b.water.flow_m3_per_s = path.flow;
  double sum = 0;
  for (int i = 0; i * dt_s < 20; ++i) {
    const auto step = specimen.advance(state, b, dt_s);
    REQUIRE(accepted(step));
    CHECK(std::abs(specimen.water_imbalance_m3(step.state)) <
          1e-12 * specimen.volume_m3(step.state));
    sum += std::abs(step.work.balance());
    state = step.state;
  }
  return sum;
}

}  // namespace

TEST_CASE("energy closes at every step, the better the shorter") {
  const LawPointer law = GENERATE(inl2_law_of_s28(), sanisand_of_s28());
  const Specimen specimen = loose(law, real());
  const Path path = GENERATE(Path{"ICU", 0, 5e-6, 0, false, Water::closed},
                             Path{"CSD", -500, 0, 0, true, Water::drained},
                             Path{"CSU", -200, 0, 0, true, Water::closed},
                             Path{"proportional", 0, 5e-6, 5e-9, false, Water::flow});
  INFO(path.name);
  const double coarse = missed(specimen, path, 2), fine = missed(specimen, path, 1);
  const double finest = missed(specimen, path, 0.5);
  // Summed over the path the error of a trapezoid falls fourfold; CSU hardly moves at all.
  CHECK(fine < 0.3 * coarse + 1e-10);
  CHECK(finest < 0.3 * fine + 1e-10);
  CHECK(coarse > 0);
}

TEST_CASE("work is what the formulae of a linear body say") {
  const Specimen specimen = loose(linear_law(30e6, 0.2), bare());
  const SpecimenBoundary b = moved(1e-6, Water::drained);
  const auto step = specimen.advance(specimen.start(), b, 1);
  REQUIRE(accepted(step));
  const double k = 30e6 * specimen.area_m2(specimen.start()) / 0.14;
  CHECK(step.work.axial == Approx(0.5 * k * 1e-12).epsilon(1e-4));
  const double shrunk = specimen.volume_m3(specimen.start()) - specimen.volume_m3(step.state);
  CHECK(step.work.cell == Approx(400e3 * shrunk));
  CHECK(step.work.drainage == Approx(-300e3 * shrunk));
  CHECK(std::abs(step.work.water) < 1e-12);
  CHECK(step.work.skeleton == Approx(step.work.axial + 100e3 * shrunk).epsilon(1e-6));
  CHECK(step.work.balance() == Approx(0).margin(1e-12));
}

TEST_CASE("parts are appended in order") {
  SpecimenStep whole, part;
  whole.outcome = StepOutcome::accepted;
  part.outcome = StepOutcome::inaccurate;
  part.message = "the error is large";
  part.done_s = 0.5;
  part.work.axial = 2;
  part.substeps = 1;
  append(whole, part);
  part.outcome = StepOutcome::accepted;
  part.message.clear();
  append(whole, part);
  CHECK(whole.done_s == 1);
  CHECK(whole.work.axial == 4);
  CHECK(whole.substeps == 2);
  CHECK(whole.outcome == StepOutcome::inaccurate);
  CHECK(whole.message == "the error is large");
  part.outcome = StepOutcome::lost_control;
  append(whole, part);
  CHECK(whole.outcome == StepOutcome::lost_control);
}
