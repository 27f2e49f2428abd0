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

TEST_CASE("missing_channels: a test in total stresses needs q and the axial strain") {
  const auto missing = [](std::vector<Quantity> columns) {
    return missing_channels(columns, true);
  };
  CHECK(missing({axial_strain, deviator_stress}).empty());
  CHECK(missing({axial_strain, axial_stress, cell_pressure}).empty());
  CHECK_THAT(missing({axial_strain, axial_stress}), Catch::Contains("test.cell_pressure_kPa"));
  CHECK_THAT(missing({axial_displacement, axial_force}),
             Catch::Contains("also needs cell_pressure_kPa;") &&
                 Catch::Contains("test.cell_pressure_kPa"));
  CHECK_FALSE(missing({deviator_stress}).empty());
  CHECK_THAT(missing_channels(std::vector{axial_strain, deviator_stress}),
             Catch::Contains("test.programme=UU, or UC"));
}

TEST_CASE("may_be_total_stress: what metadata may complete") {
  const auto may = [](std::vector<Quantity> columns) { return may_be_total_stress(columns); };
  CHECK(may({axial_displacement, axial_force}));
  CHECK(may({axial_strain, deviator_stress}));
  CHECK_FALSE(may({axial_strain}));
  CHECK_FALSE(may({axial_displacement, cell_pressure}));
}
