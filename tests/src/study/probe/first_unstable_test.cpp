// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/first_unstable.hpp"

#include <catch2/catch.hpp>

#include "sim/point/point_driver.hpp"
#include "src/study/probe/probed_state.hpp"

using namespace triax;
using sim::Axisymmetric;

TEST_CASE("the first unstable state of a path is isolated between its rows") {
  const auto set = lab::find_material("inl2/S28-general");
  const auto& law = *set.material.axisymmetric;
  // Undrained shear by displacement, in a few coarse rows.
  std::vector<study::PassedRow<Axisymmetric>> coarse;
  study::PassedRow<Axisymmetric> row{
      law.start(sim::components(sim::AxisymmetricStress{100e3, 100e3}), 1.086), {0, 0}};
  for (int i = 0; i < 6; ++i) {
    coarse.push_back(row);
    const auto control = sim::MixedControl<Axisymmetric>::strain_path(0.002);
    const auto step = sim::advance_point(law, row.state, control);
    row = {step.state, row.strain + step.strain_increment};
  }
  const auto found = study::first_unstable(set, coarse, {});
  REQUIRE(found);
  CHECK(found->axial_strain > 0.0);
  CHECK(found->eta() > 0.5);
  CHECK(found->eta() < 0.62);
  // A little before it no direction is unstable: integrated from the start.
  for (const double part : {1 - 1e-5, 1 + 1e-5}) {
    const auto step = sim::advance_point(
        law, coarse[0].state,
        sim::MixedControl<Axisymmetric>::strain_path(part * *found->axial_strain));
    study::StateToProbe<Axisymmetric> there;
    there.state = step.state;
    CHECK(study::probe_state(set, there, {}).circle.unstable() == (part > 1));
  }
  coarse.resize(1);
  CHECK_FALSE(study::first_unstable(set, coarse, {}));
}
