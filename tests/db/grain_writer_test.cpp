// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/grain_writer.hpp"

#include <SQLiteCpp/Database.h>

#include <catch2/catch.hpp>

#include "db/connection.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;

TEST_CASE("what was not made here is unknown; a run that is deleted takes all of its rows along") {
  testing::TemporaryFolder folder;
  SQLite::Database d = db::open_for_writing(folder.file("t.db"));
  lab::GrainProgramme programme;
  programme.name = "x";
  programme.source = "g.toml";
  programme.grains.state_file = "s.grains";
  const auto id = db::insert_grain_run(d, programme, {}, "2026-01-01T00:00:00Z");
  for (const char* column : {"seed", "compaction_friction_deg", "compactions"})
    CHECK(d.execAndGet(std::string("SELECT ") + column + " FROM grain_runs").isNull());
  CHECK(d.execAndGet("SELECT state_file FROM grain_runs").getString() == "s.grains");

  lab::GrainStage stage;
  stage.name = "hit";
  stage.work = lab::GrainPerturbationStage{};
  lab::GrainStageResult result;
  result.stage = &stage;
  sim::PerturbationResult hit;
  hit.points.resize(2);
  result.outcome = hit;
  db::insert_grain_stage(d, id, 1, result);
  CHECK(d.execAndGet("SELECT count(*) FROM grain_perturbation_points").getInt() == 2);
  d.exec("PRAGMA foreign_keys = ON; DELETE FROM grain_runs");
  for (const char* table : {"grain_stages", "grain_perturbations", "grain_perturbation_points"})
    CHECK(d.execAndGet(std::string("SELECT count(*) FROM ") + table).getInt() == 0);
}
