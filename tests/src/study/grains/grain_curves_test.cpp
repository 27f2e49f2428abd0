// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/grains/grain_curves.hpp"

#include <catch2/catch.hpp>

#include "src/study/grains/grain_path_findings.hpp"
#include "tests/src/sample_grains.hpp"

using namespace triax;
using namespace triax::study;
using namespace triax::src;

TEST_CASE("curves of paths that follow each other go on from the earliest start") {
  lab::GrainReport report = test::sample_run();
  report.stages[2].strain_before = {0.01, -0.004};
  report.stages[3].strain_before = {0.03, -0.01};
  const auto curves = curves_together({&report.stages[3], &report.stages[2]});
  REQUIRE(curves.size() == 2);
  CHECK(curves[0].points.front().strain.axial == Approx(0.02));
  CHECK(curves[0].points.front().strain.radial == Approx(-0.006));
  CHECK(curves[0].points.front().volumetric_strain == Approx(0.02 - 0.012));
  CHECK(curves[1].points.front().strain.axial == 0);
  CHECK(curves[1].peak == std::size_t{20});
  CHECK(curves[1].first_negative.has_value());
  REQUIRE(curves[1].marks.size() == 1);  // the one that was never reached is left out
  CHECK(curves[1].marks[0].name == "ES_a");
}

TEST_CASE("a curve whose stress does not fall has neither peak nor onset") {
  lab::GrainReport report = test::sample_run();
  std::get<lab::ReportedGrainPath>(report.stages[2].came).points.resize(20);
  const auto curves = curves_together({&report.stages[2]});
  CHECK_FALSE(curves[0].peak);
  CHECK_FALSE(curves[0].first_negative);
}

TEST_CASE("the work of each point is that of the increment that led there; of the first none") {
  const lab::GrainReport report = test::sample_run();
  const auto& path = std::get<lab::ReportedGrainPath>(report.stages[2].came);
  const auto works = works_along(path);
  REQUIRE(works.size() == path.points.size());
  CHECK_FALSE(works[0]);
  CHECK(works[5] == second_order_work(path.points[4], path.points[5], 0.8));
  CHECK(*works[5] > 0);
  CHECK(*works[30] < 0);
}

TEST_CASE(
    "onsets of W2 are not looked for where it is not stored how many points a path was to have") {
  lab::GrainReport report = test::sample_run();
  auto& path = std::get<lab::ReportedGrainPath>(report.stages[2].came);
  CHECK(path_findings(path.path, path.points).first_negative);
  path.path.samples = 0;
  CHECK_FALSE(path_findings(path.path, path.points).first_negative);
}
