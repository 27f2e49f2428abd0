#include "src/figures/subject.hpp"

#include <catch2/catch.hpp>

#include "sim/mechanics/axisymmetric.hpp"

using namespace triax;
using namespace triax::src;
using enum sim::ProbePlane;

TEST_CASE("axes of the two planes, and isotropic unloading in them") {
  CHECK(stress_x_name(axisymmetric) == "√2 dσ₃");
  CHECK(stress_x_name(plane_strain) == "dσ₃");
  CHECK(strain_x_name(axisymmetric) == "√2 dε₃");
  CHECK(sim::degrees(isotropic_unloading(axisymmetric)) == Approx(215.264).margin(1e-3));
  CHECK(sim::degrees(isotropic_unloading(plane_strain)) == Approx(225));
}

TEST_CASE("a caption says that it is simulated, with what and where") {
  CHECK(simulated_with({"inl2/S28-general", "e = 1.086"}) ==
        "Simulated with inl2/S28-general, e = 1.086.");
  CHECK(simulated_with({"my/law", "", plane_strain}) == "Simulated with my/law, plane strain.");
}
