// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_report.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/grains/specimens.hpp"
#include "tests/src/sample_grains.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::lab;

TEST_CASE("the specimen is told as it was made") {
  const GrainReport report = src::test::sample_run();
  REQUIRE(report.specimen);
  const ReportedGrains& g = *report.specimen;
  CHECK(g.grains == 4);
  CHECK(g.smallest_m == 2e-3);
  CHECK(g.median_m == 4e-3);
  CHECK(g.largest_m == 8e-3);
  CHECK(g.time_step_s == 2e-6);
  CHECK(*g.compaction_friction == Approx(sim::radians(14)));
  CHECK(g.trials == 3);
  CHECK(g.seed == 7);
  // 1 − ΣV/V of spheres of 1 to 4 mm in 50 × 40 × 40 mm
  const double solid = 4.0 / 3 * std::numbers::pi * 1e-9 * (1 + 8 + 27 + 64) / (0.05 * 0.04 * 0.04);
  CHECK(g.measures.porosity == Approx(1 - solid));
  CHECK(report.about() == "sample, 4 grains, n = 0.9948");
}

TEST_CASE("a specimen from a file has neither seed nor compaction") {
  auto programme = src::test::sample_programme();
  programme.grains.state_file = "dense.grains";
  const ReportedGrains g = reported(programme.grains, src::test::four_grains());
  CHECK(g.state_file == "dense.grains");
  CHECK_FALSE(g.compaction_friction);
  CHECK(g.trials == 0);
  CHECK(g.seed == 0);
  CHECK(GrainReport{"sample", "", {}, {}}.about() == "sample");
}

TEST_CASE("stages are told in order, each with what came of it") {
  const GrainReport report = src::test::sample_run();
  REQUIRE(report.stages.size() == 9);
  CHECK(report.stages[2].name == "R-0.8");
  CHECK(std::get<ReportedGrainPath>(report.stages[2].came).end == sim::GrainPathEnd::collapse);
  CHECK(std::get<ReportedGrainPath>(report.stages[2].came).path.ratio == 0.8);
  CHECK(std::get<ReportedGrainRest>(report.stages[4].came).rest.path_stress_pa == 12.5e3);
  CHECK(std::get<ReportedGrainRose>(report.stages[5].came).made.rose.probes.size() == 36);
  CHECK(std::get<ReportedPerturbation>(report.stages[7].came).grains_hit == 40);
}

TEST_CASE("a mark has the strains and the time since the start of its path") {
  sim::Compaction how;
  const sim::GrainState start =
      sim::compact(sim::test::small_cloud(150), sim::ContactLaw{}, how).state;
  lab::GrainPathStage work;
  work.path = src::test::strain_path(0.825);
  work.path.strain_rate_per_s = 0.5;
  work.path.axial_strain = 0.004;
  work.path.marks = {{sim::PathMark::Quantity::axial_strain, 0.002, false},
                     {sim::PathMark::Quantity::axial_strain, 1, false}};
  work.mark_names = {"half", "never"};
  lab::GrainStage stage = src::test::stage("R-0.825", "strain_path");
  stage.work = work;
  const sim::GrainPathResult made = sim::follow(start, work.path);
  lab::GrainStageResult result;
  result.stage = &stage;
  result.outcome = made;
  const auto came = std::get<ReportedGrainPath>(reported(result).came);
  const auto& marks = came.marks;
  REQUIRE(marks.size() == 2);
  REQUIRE(marks[0].at);
  const auto truth = sim::path_point(*made.marked[0], start.box, 0.825);
  CHECK(marks[0].at->strain.axial == Approx(truth.strain.axial).epsilon(1e-9));
  CHECK(marks[0].at->strain.radial == Approx(truth.strain.radial).epsilon(1e-9));
  CHECK(marks[0].at->strain.axial == Approx(0.002).epsilon(0.02));
  CHECK(marks[0].at->path_stress_pa == truth.path_stress_pa);
  CHECK(marks[0].at->time_s == Approx(made.marked[0]->time_s - start.time_s));
  CHECK(marks[1].name == "never");
  CHECK_FALSE(marks[1].at);
}
