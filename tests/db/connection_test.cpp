// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection.hpp"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <set>
#include <thread>

#include "lab/base/bad_input.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using Catch::Matchers::Contains;
using testing::TemporaryFolder;

namespace {

const int kCreate = SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE;

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

int read_int(SQLite::Database& database, const char* sql) {
  return database.execAndGet(sql).getInt();
}

}  // namespace

TEST_CASE("a new database has our settings, tables that check types, and the newest schema") {
  TemporaryFolder folder;
  SQLite::Database database = db::open_for_writing(folder.file("t.db"));
  CHECK(read_int(database, "PRAGMA application_id") == db::kApplicationId);
  CHECK(read_int(database, "PRAGMA user_version") == db::newest_schema());
  CHECK(read_int(database, "PRAGMA page_size") == 32768);
  CHECK(database.execAndGet("PRAGMA journal_mode").getString() == "wal");
  CHECK(read_int(database,
                 "SELECT count(*) FROM pragma_table_list WHERE type = 'table' AND NOT strict "
                 "AND name NOT LIKE 'sqlite_%'") == 0);
  CHECK_THROWS_WITH(database.exec("INSERT INTO scans (id, stage, q_Pa) VALUES (1, 1, 'text')"),
                    Contains("cannot store TEXT value in REAL column"));
  CHECK_THROWS_WITH(
      database.exec("INSERT INTO stages VALUES (7, 1, '', 'shear', 'open', 'load', NULL)"),
      Contains("FOREIGN KEY"));
}

TEST_CASE("SQLite has the functions that the views use") {
  SQLite::Database database(":memory:", kCreate);
  CHECK(database.execAndGet("SELECT degrees(asin(0.5))").getDouble() == Approx(30));
}

TEST_CASE("migrations run by number, keep what is there, and only once") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  {
    SQLite::Database first(path, kCreate);
    db::migrate(first, path, 1);
    CHECK(read_int(first, "PRAGMA user_version") == 1);
    CHECK(read_int(first, "SELECT count(*) FROM sqlite_schema WHERE type = 'view'") == 0);
    first.exec("INSERT INTO work_points VALUES (1, 0.5, 1, 1, 1, 1, 0.1, 51)");
  }
  SQLite::Database second = db::open_for_reading(path);
  CHECK(read_int(second, "PRAGMA user_version") == db::newest_schema());
  CHECK(read_int(second, "SELECT count(*) FROM sqlite_schema WHERE type = 'view'") > 4);
  CHECK(read_int(second, "SELECT window_readings FROM work_points") == 51);
  SQLite::Database third = db::open_for_writing(path);
  CHECK(read_int(third, "SELECT count(*) FROM work_points") == 1);
}

TEST_CASE("tests of the schema before the apparatus keep their stages, verdicts and truths") {
  TemporaryFolder folder;
  SQLite::Database database(folder.file("t.db"), kCreate);
  database.exec("PRAGMA foreign_keys = ON");
  db::migrate(database, "t.db", 3);
  database.exec(
      "INSERT INTO tests (id, name, origin, status, recorded_at, has_time, columns, writer_pid, "
      "writer_started, writer_host) VALUES (5, 'a', 'simulated', 'complete', '', 1, '', 1, 1, 'h');"
      "INSERT INTO stages VALUES (5, 2, 'second', 'shear', 'closed', 'constant_q'), "
      "(5, 1, 'first', 'consolidation', 'open', 'load');"
      "INSERT INTO verdicts VALUES (5, 'flow', 1, -0.4, 0.05, 1.29, 'angle');"
      "INSERT INTO truths VALUES (5, 1, 12.5, 0.005, 60, 100, NULL)");
  CHECK_THROWS_WITH(database.exec("INSERT INTO stages VALUES (5, 3, '', 'hold', 'open', 'load')"),
                    Contains("CHECK"));
  db::migrate(database, "t.db");
  CHECK(read_int(database, "PRAGMA user_version") == db::newest_schema());
  CHECK(database
            .execAndGet("SELECT group_concat(number || name || role || control) FROM "
                        "(SELECT * FROM stages ORDER BY rowid)")
            .getString() == "2secondshearconstant_q,1firstconsolidationload");
  CHECK(read_int(database, "SELECT count(*) FROM stages WHERE strain_path_R IS NULL") == 2);
  CHECK(database
            .execAndGet("SELECT kind || limit_source FROM verdicts WHERE "
                        "judged_until_reading IS NULL AND judged_until_reason IS NULL")
            .getString() == "flowangle");
  CHECK(database.execAndGet("SELECT time_s FROM truths").getDouble() == 12.5);
  CHECK(read_int(database, "SELECT count(*) FROM pragma_foreign_key_check") == 0);
  CHECK(database.execAndGet("PRAGMA integrity_check").getString() == "ok");
  CHECK_NOTHROW(database.exec("INSERT INTO stages VALUES (5, 3, '', 'hold', 'open', 'load', 0.4)"));
  database.exec("DELETE FROM tests");
  CHECK(read_int(database, "SELECT count(*) FROM stages") == 0);
}

TEST_CASE("of an old record without time, no strain stays under the name of a time") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  {
    SQLite::Database old(path, kCreate);
    db::migrate(old, path, 5);
    old.exec(
        "INSERT INTO tests (id, name, origin, status, recorded_at, has_time, columns, writer_pid, "
        "writer_started, writer_host) VALUES "
        "(1, 'timed', 'recorded', 'complete', '', 1, '', 1, 1, 'h'),"
        "(2, 'untimed', 'recorded', 'complete', '', 0, '', 1, 1, 'h');"
        "INSERT INTO work_points VALUES ((1 << 32) + 7, 0.5, 1, 2, 3, 0.9, 0.1, 51),"
        "((2 << 32) + 7, 0.0125, 4, 5, 6, 0.8, 0.1, 51);"
        "INSERT INTO events VALUES (1, 1, 7, 0.5, 'k', 'd'), (2, 2, 7, 0.0125, 'k', 'd');"
        "INSERT INTO instants VALUES (1, 'onset', 7, 0.5, 0.01, 1, 1, 1),"
        "(2, 'onset', 7, 0.0125, 0.01, 1, 1, 1);"
        "INSERT INTO criteria VALUES (1, 1, 'c', 1, 7, 0.5, 0.6, ''),"
        "(2, 2, 'c', 1, 7, 0.0125, 0.6, '')");
  }
  SQLite::Database database = db::open_for_reading(path);
  const auto text = [&](const char* sql) { return database.execAndGet(sql).getString(); };
  CHECK(text("SELECT group_concat(test || ' ' || axis) FROM tests") ==
        "timed time,untimed axial_strain");
  CHECK(text("SELECT json_group_array(json_array(axis, time_s, axial_strain_path, "
             "eulerian_Pa_per_s2, eulerian_Pa_per_strain2, normalised)) "
             "FROM second_order_work") ==
        R"([["time",0.5,null,2.0,null,0.9],["axial_strain",null,0.0125,null,5.0,0.8]])");
  for (const char* table : {"events", "instants", "criteria"})
    CHECK(text(("SELECT json_group_array(time_s) FROM (SELECT time_s FROM " + std::string(table) +
                " ORDER BY test_id)")
                   .c_str()) == "[0.5,null]");
}

TEST_CASE("migrate: a limit that was the largest ratio of the test becomes unknown") {
  TemporaryFolder folder;
  SQLite::Database database(folder.file("t.db"), kCreate);
  db::migrate(database, "t.db", 18);
  const std::string own =
      "largest stress ratio mobilised in this test; the limit itself is unknown";
  for (const std::string& row :
       {"1, 'flow', 1, 1.3, '" + own + "'", "2, 'flow', NULL, 1.3, '" + own + "'",
        "3, 'none', 0, 1.3, '" + own + "'",
        std::string("4, 'flow', 1, 1.3, 'friction angle of the specimen'")}) {
    database.exec(
        "INSERT INTO tests (id, name, origin, status, stored_at, has_time, columns) VALUES (" +
        row.substr(0, 1) + ", 'a', 'recorded', 'complete', '', 1, '')");
    database.exec(
        "INSERT INTO verdicts (test_id, kind, inside_limit_surface, limit_stress_ratio, "
        "limit_source) VALUES (" +
        row + ")");
  }
  db::migrate(database, "t.db");
  CHECK(database
            .execAndGet("SELECT json_group_array(json_array(inside_limit_surface, "
                        "limit_stress_ratio)) FROM verdicts")
            .getString() == "[[null,null],[null,null],[0,1.3],[1,1.3]]");
  CHECK(read_int(database, "SELECT count(*) FROM verdicts WHERE limit_source LIKE '%mobilised%'") ==
        0);
}

TEST_CASE("migrate: an old verdict has no loss of control and keeps its onset", "[db]") {
  TemporaryFolder folder;
  SQLite::Database database(folder.file("t.db"), kCreate);
  db::migrate(database, "t.db", 23);
  database.exec(
      "INSERT INTO tests (id, name, origin, status, stored_at, has_time, columns) "
      "VALUES (1, 'a', 'simulated', 'complete', '', 1, '');"
      "INSERT INTO verdicts (test_id, kind, eta_low, noticed_reading) VALUES (1, 'flow', 0.5, 9);"
      "INSERT INTO instants (test_id, kind, reading, q_kPa, p_eff_kPa) "
      "VALUES (1, 'onset', 7, 60, 100);"
      "INSERT INTO run_aways (test_id, number, start_s) VALUES (1, 1, 0.5)");
  db::migrate(database, "t.db");
  CHECK(database
            .execAndGet("SELECT json_array(reading, eta, eta_low, detected_at_reading, "
                        "loss_of_control_reading, total_eta_low) FROM collapses")
            .getString() == "[7,0.6,0.5,9,null,null]");
  CHECK(read_int(database, "SELECT q_kPa IS NULL FROM run_aways") == 1);
}

TEST_CASE("a database made in one step is what all migrations come to") {
  const auto schema_of = [](SQLite::Database& database) {
    SQLite::Statement all(
        database, "SELECT type || ' ' || name || ': ' || coalesce(sql, '') FROM sqlite_schema");
    std::set<std::string> parts;
    while (all.executeStep()) parts.insert(all.getColumn(0).getString());
    return parts;
  };
  SQLite::Database stepwise(":memory:", kCreate), at_once(":memory:", kCreate);
  db::migrate(stepwise, "steps.db", 1);
  db::migrate(stepwise, "steps.db");
  db::migrate(at_once, "once.db");
  CHECK(schema_of(at_once).size() > 50);
  CHECK(schema_of(at_once) == schema_of(stepwise));
  CHECK(read_int(at_once, "PRAGMA user_version") == db::newest_schema());
}

TEST_CASE("a migration that fails leaves the database as it was") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  SQLite::Database database(path, kCreate);
  db::migrate(database, path, 1);
  database.exec("CREATE TABLE states (a)");  // in the way of the next migration
  CHECK_THROWS_AS(db::migrate(database, path), SQLite::Exception);
  CHECK(read_int(database, "PRAGMA user_version") == 1);
  CHECK(read_int(database, "SELECT count(*) FROM sqlite_schema WHERE type = 'view'") == 0);
}

TEST_CASE("what is no database of ours is refused and not touched") {
  TemporaryFolder folder;
  const std::string foreign = folder.file("foreign.db"), newer = folder.file("newer.db");
  const std::string text = folder.file("text.csv");
  {
    SQLite::Database made(foreign, kCreate);
    made.exec("CREATE TABLE t (x); PRAGMA user_version = 1");
    SQLite::Database ours = db::open_for_writing(newer);
    ours.exec("PRAGMA user_version = 99; PRAGMA journal_mode = DELETE");
  }
  std::ofstream(text) << std::string(2000, 'a');
  for (const auto& [path, words] : {std::pair(foreign, "another program"),
                                    std::pair(newer, "newer"), std::pair(text, "not an SQLite")}) {
    INFO(path);
    const std::string before = bytes_of(path);
    CHECK_THROWS_AS(db::open_for_writing(path), lab::BadInput);
    CHECK_THROWS_WITH(db::open_for_writing(path), Contains(path) && Contains(words));
    CHECK_THROWS_WITH(db::open_for_reading(path), Contains(path) && Contains(words));
    CHECK(bytes_of(path) == before);
  }
}

TEST_CASE("two threads make the same new database, and neither takes it for a foreign one",
          "[threads]") {
  TemporaryFolder folder;
  for (int round = 0; round < 200; ++round) {
    const std::string path = folder.file(std::to_string(round) + ".db");
    const auto failure = [&path] {
      try {
        db::open_for_writing(path);
      } catch (const std::exception& error) {
        return std::string(error.what());
      }
      return std::string();
    };
    std::string first, second;
    {
      std::jthread other([&] { first = failure(); });
      // So that some round looks at the file just when the other's tables appear.
      std::this_thread::sleep_for(std::chrono::microseconds(50) * round);
      second = failure();
    }
    INFO("round " << round);
    REQUIRE(first == "");
    REQUIRE(second == "");
  }
}

TEST_CASE("a database that another thread is making is empty or ours to a reader", "[threads]") {
  TemporaryFolder folder;
  for (int round = 0; round < 50; ++round) {
    const std::string path = folder.file(std::to_string(round) + ".db");
    std::ofstream(path).flush();
    const std::jthread writer([&] { db::open_for_writing(path); });
    for (bool ours = false; !ours;) {
      try {
        db::open_for_reading(path);
        ours = true;
      } catch (const lab::BadInput& error) {
        INFO("round " << round);
        REQUIRE_THAT(error.what(), Contains("is empty"));
      }
    }
  }
}

TEST_CASE("a limit on the size of files is told at once where nothing will lift it") {
  const TemporaryFolder folder;
  int file = 0;
  for (const rlim_t kilobytes : {10, 100, 300, 1000})
    for (const bool hard : {true, false}) {
      const std::string path = folder.file("t" + std::to_string(file++) + ".db");
      const pid_t child = fork();
      if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{kilobytes * 1024, hard ? kilobytes * 1024 : RLIM_INFINITY};
        setrlimit(RLIMIT_FSIZE, &limit);
        try {
          db::open_for_writing(path);
        } catch (const lab::WorkFailed& error) {
          const std::string words = error.what();
          const bool told = words.find(" kB (ulimit -f)") != std::string::npos;
          _exit((told ? 0 : 10) + (dynamic_cast<const db::MayPass*>(&error) != nullptr ? 1 : 2));
        }
        _exit(0);
      }
      int status = -1;
      waitpid(child, &status, 0);
      INFO(kilobytes << " kB, " << (hard ? "hard" : "soft"));
      CHECK(WEXITSTATUS(status) == (hard ? 2 : 1));
    }
}

TEST_CASE("open_for_writing: a device, pipe or socket is refused at once, nothing beside it") {
  const TemporaryFolder folder;
  const std::string pipe = folder.file("pipe"), link = folder.file("link");
  mkfifo(pipe.c_str(), 0600);
  std::filesystem::create_symlink("/dev/full", link);
  for (const std::string& path : {pipe, link, std::string("/dev/null")}) {
    INFO(path);
    CHECK_THROWS_WITH(db::open_for_writing(path), Contains("regular file"));
    CHECK_THROWS_WITH(db::open_for_reading(path), Contains("regular file"));
    CHECK_THROWS_WITH(db::check_there(path), Contains("regular file"));
  }
  for (const char* path : {"", ":memory:"})
    CHECK_THROWS_WITH(db::open_for_writing(path), Contains("must be a file"));
  CHECK(std::ranges::distance(std::filesystem::directory_iterator(folder.file(""))) == 2);
}

TEST_CASE("paths that cannot be a database say why") {
  TemporaryFolder folder;
  const std::string directory = folder.file("d"), nowhere = folder.file("no/t.db");
  std::filesystem::create_directory(directory);
  CHECK_THROWS_WITH(db::open_for_writing(directory), Contains("is a folder"));
  CHECK_THROWS_WITH(db::open_for_writing(nowhere), Contains("does not exist; create it first"));
  CHECK_THROWS_WITH(db::open_for_reading(directory), Contains("is a folder"));
  CHECK_THROWS_AS(db::open_for_reading(nowhere), lab::BadInput);
  std::ofstream(folder.file("empty.db")).flush();
  CHECK_THROWS_WITH(db::open_for_reading(folder.file("empty.db")), Contains("is empty"));
}

TEST_CASE(
    "reading an old database gives the newest schema and leaves its bytes, and nothing beside") {
  TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  {
    SQLite::Database old(path, kCreate);
    db::migrate(old, path, 1);
    old.exec("INSERT INTO work_points VALUES (1, 0.5, 1, 1, 1, 1, 0.1, 51)");
  }
  const std::string before = bytes_of(path);
  {
    SQLite::Database database = db::open_for_reading(path);
    CHECK(read_int(database, "PRAGMA user_version") == db::newest_schema());
    CHECK(read_int(database, "SELECT axial_strain_path IS NULL FROM work_points") == 1);
    CHECK_THROWS_AS(database.exec("DELETE FROM work_points"), SQLite::Exception);
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::temp_directory_path()))
      CHECK_THAT(entry.path().string(), !Contains("triax-reading"));
  }
  CHECK(bytes_of(path) == before);
}
