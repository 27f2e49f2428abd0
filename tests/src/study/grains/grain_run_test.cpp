// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/grains/grain_run.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "lab/grains/grain_programme_reader.hpp"
#include "tests/db/temporary_folder.hpp"
#include "tests/lab/grains/small_programme.hpp"

using namespace triax;

namespace {

lab::GrainProgramme two_stages() {
  auto programme = lab::read_grain_programme(triax::test::kSmallGrains, "g.toml");
  programme.stages.resize(2);
  return programme;
}

}  // namespace

TEST_CASE("a run gives what the database holds, and tells the listener all that happens") {
  testing::TemporaryFolder folder;
  const auto programme = two_stages();
  std::vector<std::string> begun, ended;
  int made = 0;
  lab::GrainListener also;
  also.made = [&](const lab::GrainsMade&) { ++made; };
  also.stage_started = [&](const lab::GrainStage& stage, const sim::GrainState&) {
    begun.push_back(stage.name);
  };
  also.stage_ended = [&](const lab::GrainStage& stage, const sim::GrainState&,
                         const lab::GrainStageResult&) { ended.push_back(stage.name); };
  const auto run = study::run_grains(programme, {}, folder.file("t.db"), also);
  REQUIRE(run);
  CHECK(run->status == db::TestStatus::complete);
  CHECK(run->id == 1);
  REQUIRE(run->report.stages.size() == 2);
  CHECK(run->report.stages[1].name == "drained");
  CHECK(made == 1);
  CHECK(begun == std::vector<std::string>{"isotropic", "drained"});
  CHECK(ended == begun);
}

TEST_CASE("a run that is stopped is interrupted with what had ended, or never was") {
  testing::TemporaryFolder folder;
  const auto programme = two_stages();
  bool stop = true;
  lab::GrainListener also;
  const lab::GrainRunOptions options{1, [&](double, const std::string&) { return !stop; }};
  CHECK_FALSE(study::run_grains(programme, options, folder.file("t.db"), also));
  CHECK_FALSE(std::filesystem::exists(folder.file("t.db")));
  stop = false;
  also.stage_started = [&](const lab::GrainStage& stage, const sim::GrainState&) {
    stop = stage.name == "drained";
  };
  const auto run = study::run_grains(programme, options, folder.file("t.db"), also);
  REQUIRE(run);
  CHECK(run->status == db::TestStatus::interrupted);
  REQUIRE(run->report.stages.size() == 1);
  CHECK(run->report.stages[0].name == "isotropic");
}
