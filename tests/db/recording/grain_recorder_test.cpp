// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/grain_recorder.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>

#include "db/connection.hpp"
#include "db/grain_store.hpp"
#include "db/query.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/grains/grain_programme_reader.hpp"
#include "tests/db/temporary_folder.hpp"
#include "tests/lab/grains/small_programme.hpp"

using namespace triax;

namespace {

const lab::GrainProgramme& small() {
  static const auto programme = lab::read_grain_programme(test::kSmallGrains, "g.toml");
  return programme;
}

struct Ran {
  lab::GrainsMade made;
  std::vector<lab::GrainStageResult> results;
};
const Ran& ran() {
  static const Ran all = [] {
    Ran r;
    lab::GrainListener listener;
    listener.made = [&](const lab::GrainsMade& made) { r.made = made; };
    listener.stage_ended = [&](const lab::GrainStage&, const sim::GrainState&,
                               const lab::GrainStageResult& result) {
      r.results.push_back(result);
    };
    lab::run_grains(small(), {}, {listener});
    return r;
  }();
  return all;
}

double value(SQLite::Database& database, const std::string& sql) {
  return database.execAndGet(sql).getDouble();
}
std::string word(SQLite::Database& database, const std::string& sql) {
  return database.execAndGet(sql).getString();
}

}  // namespace

TEST_CASE("a run of grains is in the database with every value it came to") {
  testing::TemporaryFolder folder;
  db::GrainRecorder recorder(folder.file("t.db"), small());
  CHECK(folder.is_empty());
  const lab::GrainListener listener = recorder.listener();
  listener.made(ran().made);
  for (const auto& result : ran().results) listener.stage_ended(*result.stage, {}, result);
  CHECK(recorder.finish() == 1);

  SQLite::Database d = db::open_for_reading(folder.file("t.db"));
  CHECK(word(d, "SELECT status FROM grain_runs") == "complete");
  CHECK(word(d, "SELECT origin FROM grain_runs") == "simulated");
  CHECK(value(d, "SELECT porosity FROM grain_runs") == ran().made.measures.porosity);
  CHECK(value(d, "SELECT compaction_friction_deg FROM grain_runs") == Approx(20));
  CHECK(value(d, "SELECT friction_angle_deg FROM grain_runs") == Approx(30));
  CHECK(value(d, "SELECT count(*) FROM grain_stages") == 7);
  const auto& drained = std::get<sim::GrainPathResult>(ran().results[1].outcome).points;
  CHECK(value(d, "SELECT count(*) FROM grain_points WHERE stage = 2") ==
        static_cast<double>(drained.size()));
  CHECK(value(d, "SELECT q_kPa FROM grain_points WHERE stage = 2 ORDER BY number DESC") ==
        Approx(drained.back().q_pa / 1e3).epsilon(1e-14));
  CHECK(value(d,
              "SELECT volumetric_strain_pct FROM grain_points WHERE stage = 2 "
              "ORDER BY number DESC") == Approx(100 * drained.back().volumetric_strain));
  CHECK(d.execAndGet("SELECT strain_path_R FROM grain_stages WHERE number = 2").isNull());
  CHECK(value(d, "SELECT strain_path_R FROM grain_stages WHERE number = 5") == 0.9);
  CHECK(word(d, "SELECT started_from FROM grain_stages WHERE number = 3") == "a point");
  CHECK(value(d, "SELECT count(*) FROM grain_probes") == 5);
  CHECK(d.execAndGet("SELECT alpha_deg FROM grain_probes WHERE number = 0").isNull());
  const auto& rose = std::get<lab::GrainRose>(ran().results[3].outcome).rose;
  CHECK(value(d, "SELECT alpha_deg FROM grain_probes WHERE number = 2") == Approx(90));
  CHECK(value(d, "SELECT work_lagrangian_J_per_m3 FROM grain_probes WHERE number = 2") ==
        rose.probes[1].work.lagrangian);
  CHECK(value(d,
              "SELECT max(abs(work_eulerian_J_per_m3 - stress_part_J_per_m3 - "
              "volume_part_J_per_m3 - transport_part_J_per_m3)) FROM grain_probes") < 1e-12);
  const auto& hit = std::get<sim::PerturbationResult>(ran().results[6].outcome);
  CHECK(value(d, "SELECT load_step_Pa FROM grain_perturbations") == 100);
  CHECK(value(d, "SELECT count(*) FROM grain_perturbation_points") ==
        static_cast<double>(hit.points.size()));
}

TEST_CASE("the peak of a path of grains is that of its largest s1 - s3/R, with its own strain") {
  testing::TemporaryFolder folder;
  Ran r = ran();
  auto& points = std::get<sim::GrainPathResult>(r.results[4].outcome).points;
  points.resize(3);
  for (int k = 0; k < 3; ++k) {
    points[k].path_stress_pa = k == 1 ? 30e3 : 10e3 + k;
    points[k].strain.axial = 0.01 * k;
    points[k].p_pa = 100e3;
    points[k].q_pa = 50e3;
  }
  db::GrainRecorder recorder(folder.file("t.db"), small());
  recorder.made(r.made);
  for (const auto& result : r.results) recorder.ended(result);
  recorder.finish();
  SQLite::Database d = db::open_for_reading(folder.file("t.db"));
  SQLite::Statement peak(d,
                         "SELECT peak_path_stress_kPa, at_axial_strain_pct, eta, "
                         "path_stress_at_end_kPa FROM grain_peaks WHERE stage = 5");
  REQUIRE(peak.executeStep());
  CHECK(peak.getColumn(0).getDouble() == Approx(30));
  CHECK(peak.getColumn(1).getDouble() == Approx(1));
  CHECK(peak.getColumn(2).getDouble() == Approx(0.5));
  CHECK(peak.getColumn(3).getDouble() == Approx(10.002));
}

TEST_CASE("a run of grains that does not finish is interrupted; every named query takes it") {
  testing::TemporaryFolder folder;
  {
    db::GrainRecorder recorder(folder.file("t.db"), small());
    CHECK_THROWS_AS(recorder.ended(ran().results[0]), lab::WorkFailed);
    CHECK_THROWS_AS(recorder.finish(), lab::WorkFailed);
    recorder.made(ran().made);
    for (const auto& result : ran().results) recorder.ended(result);
    SQLite::Database meanwhile = db::open_for_reading(folder.file("t.db"));
    CHECK(word(meanwhile, "SELECT status FROM grain_runs") == "running");
  }
  SQLite::Database d = db::open_for_reading(folder.file("t.db"));
  CHECK(word(d, "SELECT status FROM grain_runs") == "interrupted");
  for (const char* name :
       {"grain_runs", "grain_stages", "grain_peaks", "grain_probes", "grain_perturbations"}) {
    INFO(name);
    int rows = 0;
    db::query(
        folder.file("t.db"), name, [](const auto&) {}, [&](const auto&) { ++rows; });
    CHECK(rows > 0);
  }
}

TEST_CASE("a run of grains gives signs of life while a stage is computed, and none when it is over",
          "[threads]") {
  testing::TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  const auto age = [&](const std::string& by) {
    SQLite::Database(path, SQLite::OPEN_READWRITE)
        .exec("UPDATE leases SET last_sign_of_life = datetime('now', '" + by + "')");
  };
  db::GrainRecorder recorder(path, small());
  recorder.made(ran().made);
  CHECK(db::GrainStore(path).load(1).status == db::TestStatus::running);
  age("-1 hour");
  CHECK(db::GrainStore(path).load(1).status == db::TestStatus::interrupted);
  bool signs = false;  // without a word from the run itself
  for (int i = 0; i < 100 && !signs; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    signs = db::GrainStore(path).load(1).status == db::TestStatus::running;
  }
  CHECK(signs);
  recorder.finish();
  CHECK_FALSE(db::GrainStore(path).load(1).sign_of_life);
}

TEST_CASE("a run of grains waits for a lock and loses nothing; a stage after it is stored as well",
          "[threads]") {
  testing::TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  std::vector<std::string> said;
  using namespace std::chrono_literals;
  db::GrainRecorder recorder(
      path, small(),
      {.quiet = 50ms, .again = 20ms, .say = [&](const std::string& s) { said.push_back(s); }});
  recorder.made(ran().made);
  SQLite::Database foreign(path, SQLite::OPEN_READWRITE, 5000);
  foreign.exec("BEGIN IMMEDIATE");
  std::thread frees([&] {
    std::this_thread::sleep_for(500ms);
    foreign.exec("COMMIT");
  });
  for (const auto& result : ran().results) recorder.ended(result);
  CHECK(recorder.finish() == 1);
  frees.join();
  const auto run = db::GrainStore(path).load(1);
  CHECK(run.status == db::TestStatus::complete);
  CHECK(run.report.stages.size() == ran().results.size());
  CHECK(said.size() == 2);
}

TEST_CASE("GrainRecorder: a database that is renamed gets a successor with the whole run") {
  testing::TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  std::string said;
  db::GrainRecorder recorder(path, small(), {.say = [&](const std::string& s) { said += s; }});
  recorder.made(ran().made);
  recorder.ended(ran().results.front());
  std::filesystem::rename(path, folder.file("e.db"));
  for (std::size_t i = 1; i < ran().results.size(); ++i) recorder.ended(ran().results[i]);
  CHECK(recorder.finish() == 1);
  const auto run = db::GrainStore(path).load(1);
  CHECK(run.status == db::TestStatus::complete);
  CHECK(run.report.stages.size() == ran().results.size());
  CHECK(said.find("renamed, removed or replaced") != std::string::npos);
  CHECK(db::GrainStore(folder.file("e.db")).load(1).report.stages.size() == 1);
}

TEST_CASE("GrainRecorder: follows a folder that is renamed") {
  const testing::TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("d"));
  db::GrainRecorder recorder(folder.file("d/t.db"), small());
  recorder.made(ran().made);
  std::filesystem::rename(folder.file("d"), folder.file("e"));
  for (const auto& result : ran().results) recorder.ended(result);
  const std::int64_t id = recorder.finish();
  CHECK(recorder.path() == folder.file("e/t.db"));
  CHECK(db::GrainStore(recorder.path()).load(id).status == db::TestStatus::complete);
}

TEST_CASE("a file that is no database of ours stays as it is") {
  testing::TemporaryFolder folder;
  {
    SQLite::Database other(folder.file("o.db"), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    other.exec("CREATE TABLE t (x)");
  }
  db::GrainRecorder recorder(folder.file("o.db"), small());
  CHECK_THROWS_AS(recorder.made(ran().made), lab::BadInput);
}
