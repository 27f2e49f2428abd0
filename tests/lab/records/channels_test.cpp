// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/channels.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace triax::lab;
using enum Quantity;

TEST_CASE("raw channels or a reduced set suffice, halves of either do not") {
  const auto missing = [](std::vector<Quantity> columns) { return missing_channels(columns); };
  CHECK(missing({axial_displacement, axial_force, cell_pressure}).empty());
  CHECK(missing({axial_strain, deviator_stress, mean_effective_stress}).empty());
  CHECK(missing({axial_strain, effective_axial_stress, effective_radial_stress}).empty());
  CHECK_THAT(missing({axial_displacement, cell_pressure}),
             Catch::Contains("also needs axial_force_kN"));
  CHECK_FALSE(missing({axial_strain, deviator_stress}).empty());
  CHECK_FALSE(missing({deviator_stress, mean_effective_stress}).empty());
  CHECK_THAT(missing({}), Catch::Contains("found: none"));
}
