// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/triaxial_axes.hpp"

#include <catch2/catch.hpp>

using namespace triax::sim;

TEST_CASE("Triaxial axes: stress, strain and drives of axis 1 are those of the box's third") {
  GrainState s;
  s.box = {{0, 0, 0}, {1, 1, 2}};
  s.walls.force_n = {2, 2, 4, 4, 5, 7};
  CHECK(axisymmetric_stress(s).axial == 6);
  CHECK(axisymmetric_stress(s).radial == Approx(0.5 * (1 + 2)));
  const GrainBox shorter{{0, 0, 0}, {1, 1.1, 1.8}};
  CHECK(axisymmetric_strain(s.box, shorter).axial == Approx(std::log(2 / 1.8)));
  CHECK(axisymmetric_strain(s.box, shorter).radial == Approx(-0.5 * std::log(1.1)));
  CHECK(path_stress({10, 4}, 0.8) == Approx(5));
  const auto drives = strain_path_drives(strain_rate_drive(0.1), 0.8);
  CHECK(drives[2] == strain_rate_drive(0.1));
  CHECK(drives[0] == following_drive(2, -0.625));
  CHECK(drives[1] == drives[0]);
}
