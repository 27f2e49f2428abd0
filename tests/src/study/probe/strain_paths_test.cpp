// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/strain_paths.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax;

namespace {

study::StrainPathsRequest loose_request(const std::string& material) {
  return {.material = lab::find_material(material),
          .p = 100e3,
          .void_ratio = 1.086,
          .R = {0.7, 1.0},
          .axial_strain = 0.02};
}

}  // namespace

TEST_CASE("strain paths come in the order of their R, from the start that is asked for") {
  const auto result = study::strain_paths(loose_request("inl2/S28-general"));
  REQUIRE(result.paths.size() == 2);
  CHECK(result.paths[0].R == 0.7);
  CHECK(result.paths[1].R == 1);
  for (const auto& path : result.paths) CHECK(path.points.front().p == Approx(100e3));
  REQUIRE(result.paths[1].peak);
  CHECK(result.paths[1].peak->eta() == Approx(0.5954).margin(5e-4));
  REQUIRE(result.warnings.size() == 1);
  CHECK(result.warnings[0].find("R 0.7: ") == 0);
}

TEST_CASE("a strain path whose stress vanishes without a peak is warned of, with the place") {
  auto request = loose_request("inl2/S28-general");
  request.R = {0.5};
  const auto result = study::strain_paths(request);
  CHECK_FALSE(result.paths[0].peak);
  REQUIRE(result.warnings.size() == 2);
  CHECK(result.warnings[0].find("R 0.5: p' falls below 2 kPa at an axial strain of 0.75") == 0);
}

TEST_CASE(
    "a start of strain paths that the law refuses is bad input; outside its range a warning") {
  auto request = loose_request("hypoplastic/S28-MT");
  request.p = -1e3;
  request.void_ratio = 0.9;
  CHECK_THROWS_WITH(study::strain_paths(request), Catch::Contains("out of range for"));
  request = loose_request("inl2/S28-general");
  request.void_ratio = 1.25;
  request.R = {1.0};
  request.axial_strain = 0.001;
  CHECK_FALSE(study::strain_paths(request).warnings.empty());
}
