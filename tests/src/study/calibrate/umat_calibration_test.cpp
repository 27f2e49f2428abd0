// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "bench/calibrate/virtual_tests.hpp"
#include "src/study/calibrate/calibration.hpp"
#include "tests/sim/materials/umat_fixture.hpp"

using namespace triax;
using namespace triax::study;

TEST_CASE("numbers of a UMAT are found from tests that it made") {
  if (!sim::test::umat_fixture_is_there()) return;
  lab::MaterialSet start{.name = "umat/cone", .law = sim::find_law("umat")};
  start.parameters = sim::test::umat_fixture();
  start.material = sim::test::make_umat(start.parameters);
  CalibrationRequest request{.start = start, .searches = 1, .seed = 1, .threads = 1};
  std::mt19937_64 dice(1);
  for (const double p_kPa : {100, 200})
    request.paths.push_back(
        bench::virtual_path(start, {Imposed::drained, p_kPa, 0.8}, {}, dice, 60));
  request.free = lab::read_search(R"([search]
"properties.2" = [5000.0, 40000.0]
"properties.3" = [0.9, 1.5]
)",
                                  "umat.toml");
  request.start.parameters.lists["properties"][1] = 20e3;
  request.start.parameters.lists["properties"][2] = 1.0;
  request.start.material = sim::test::make_umat(request.start.parameters);
  const auto found = calibrate(request);
  REQUIRE(found.parameters.size() == 2);
  CHECK(found.parameters[0].value == Approx(sim::test::kShear).epsilon(0.01));
  CHECK(found.parameters[1].value == Approx(sim::test::kM).epsilon(0.01));
  CHECK(found.material.parameters.lists.at("properties")[2] == found.parameters[1].value);
}
