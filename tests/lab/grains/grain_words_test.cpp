// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_words.hpp"

#include <catch2/catch.hpp>

using namespace triax;
using namespace triax::lab;

TEST_CASE("how a stage of grains ended, in words") {
  GrainStage stage;
  stage.work = GrainPathStage{};
  GrainStageResult result;
  result.stage = &stage;
  sim::GrainPathResult path;
  path.end = sim::GrainPathEnd::collapse;
  result.outcome = path;
  CHECK(ending(result) == "collapse");
  CHECK(!at_rest(result));
  std::get<GrainPathStage>(stage.work).path.kind = sim::GrainPathKind::isotropic;
  CHECK(at_rest(result) == false);

  GrainRose rose;
  rose.rose.null_probe.at_rest = true;
  rose.rose.probes.resize(2);
  rose.rose.probes[0].at_rest = true;
  result.outcome = rose;
  CHECK(ending(result) == "some not at rest");
  CHECK(at_rest(result) == false);
  rose.rose.probes[1].at_rest = true;
  result.outcome = rose;
  CHECK(ending(result) == "all at rest");
  CHECK(at_rest(result) == true);

  sim::PerturbationResult hit;
  hit.end = sim::PerturbationEnd::undecided;
  result.outcome = hit;
  CHECK(ending(result) == "undecided");
  CHECK(at_rest(result) == false);
  CHECK(word(sim::StiffnessReading::literal) == "literal");
  CHECK(word(sim::GrainPathEnd::most_steps) == "most_steps");
  CHECK(word(sim::GrainPathKind::strain_path) == "strain_path");
}
