// SPDX-License-Identifier: GPL-3.0-or-later
// triax replay of many records: a job file, a folder, a folder that is watched.
#include <SQLiteCpp/Transaction.h>

#include <iomanip>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/running.hpp"

using namespace triax::cli_tests;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr const char* kTable =
    "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n"
    "0.2,9,103\n";

json document_of(const Workplace& here, const std::string& arguments) {
  const Outcome outcome = here.triax(arguments);
  INFO(arguments << ": " << outcome.err);
  REQUIRE(outcome.status == 0);
  return json::parse(outcome.out);
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A folder f with two records, a letter and what belongs to no record.
void fill(const Workplace& here) {
  fs::create_directories(here / "f/inner");
  write(here / "f/b.csv", kTable);
  write(here / "f/a.csv", content(source("samples/records/icu_6.csv")));
  write(here / "f/letter.txt", "Dear client,\nhere are the records.\n");
  write(here / "f/.hidden.csv", kTable);
  write(here / "f/inner/c.csv", kTable);
}

/// Rows of an undrained test.
std::string undrained(int count, int cell, double step = 0.5) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(3);
  for (int i = 0; i < count; ++i)
    out << step * i << ',' << 100.0 * i / (i + 4) << ',' << 200 + 50.0 * i / (i + 6) << ',' << cell
        << '\n';
  return out.str();
}

constexpr const char* kUndrained =
    "Axial strain (%),Deviator stress (kPa),Pore pressure (kPa),Cell pressure (kPa)\n";

/// Waits up to half a minute until the output of `watch` holds `part`.
bool says(const Running& watch, const std::string& part) {
  for (int i = 0; i < 300; ++i) {
    if (holds(watch.out(), part)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  UNSCOPED_INFO(watch.out() << watch.err());
  return false;
}

}  // namespace

TEST_CASE("replay: a dialect that is remembered beside the database") {
  const Workplace here;
  write(here / "x.csv", "alpha,beta,gamma\n0,0,100\n0.1,5,101\n0.2,9,103\n");
  CHECK(here.triax("replay x.csv --db lab.db").status == 2);
  // SHA-256 of "alpha\x1fbeta\x1fgamma\x1f\x1e", the first 32 digits, by sha256sum
  fs::create_directories(here / "lab.db.dialects");
  write(here / "lab.db.dialects/0fefb3b5c63a5987d38f6a309ef7403b.toml",
        "name = \"mine\"\n[columns]\naxial_strain = { column = 1, unit = \"%\" }\n"
        "deviator_stress = { column = 2, unit = \"kPa\" }\n"
        "mean_effective_stress = { column = 3, unit = \"kPa\" }\n");
  const json test = document_of(here, "replay x.csv --db lab.db --json");
  CHECK(test["test"]["dialect"] == "mine");
  CHECK(holds(test["warnings"].dump(), "lab.db.dialects"));
  CHECK(here.triax("replay x.csv --db other.db").status == 2);
}

TEST_CASE("replay --job: values for all records, for some, and --set above both") {
  const Workplace here;
  for (const char* name : {"ICU-1.csv", "ICU-2.csv", "x.csv"}) write(here / name, kTable);
  write(here / "job.toml",
        "[labels]\nclient = \"A\"\nborehole = \"B0\"\n[test]\nprogramme = \"CU\"\n[stages.1]\n"
        "drainage = \"closed\"\n[[file]]\nmatch = \"ICU-*.csv\"\nlabels.borehole = \"B1\"\n"
        "[[file]]\nmatch = \"none-*\"\nlabels.sample = \"S\"\n");
  const Outcome replayed =
      here.triax("replay ICU-1.csv ICU-2.csv x.csv --job job.toml --set labels.client=C --json");
  REQUIRE(replayed.status == 0);
  CHECK(holds(replayed.err, "job.toml:11: no record matches 'none-*'"));
  const json tests = json::parse(replayed.out);
  REQUIRE(tests.size() == 3);
  const auto label = [](const json& test, const std::string& name) {
    for (const json& note : test["notes"])
      if (note["label"] == name) return note["text"].get<std::string>();
    return std::string();
  };
  for (const json& test : tests) {
    CHECK(test["test"]["programme"] == "CU");
    CHECK(label(test, "Client") == "C");
  }
  CHECK(label(tests[0], "Borehole") == "B1");
  CHECK(label(tests[2], "Borehole") == "B0");

  write(here / "job.toml", "[specimen]\nheight_mm = 140\nhieght_mm = 1\n");
  const Outcome refused = here.triax("replay x.csv --job job.toml --db new.db");
  CHECK(refused.status == 2);
  CHECK(holds(refused.err,
              "job.toml:3: unknown key 'specimen.hieght_mm'; did you mean "
              "'specimen.height_mm'"));
  CHECK_FALSE(here.has("new.db"));
  write(here / "job.toml", "[stages.7]\nrole = \"shear\"\n");
  CHECK(holds(here.triax("replay x.csv --job job.toml").err, "job.toml:2: x.csv has no stage 7"));
}

TEST_CASE("replay FOLDER: a table of the files, and nothing twice") {
  const Workplace here;
  fill(here);
  const Outcome first = here.triax("replay f --db f/t.db");
  INFO(first.out << first.err);
  CHECK(first.status == 0);
  CHECK(holds(first.err, "letter.txt: no record: "));
  CHECK(holds(first.out, "3 files: 2 stored, 0 read before, 0 failed, 1 no records"));
  CHECK(first.out.find("a.csv") < first.out.find("b.csv"));
  CHECK(document_of(here, "tests --json --db f/t.db").size() == 2);

  write(here / "f/d.csv", std::string(kTable) + "0.3,x,104\n");
  const Outcome second = here.triax("replay f --db f/t.db");
  CHECK(second.status == 2);
  CHECK(holds(second.out, "4 files: 0 stored, 2 read before, 1 failed, 1 no records"));
  CHECK(holds(second.err, "d.csv: failed: "));
  CHECK(document_of(here, "tests --json --db f/t.db").size() == 2);

  CHECK(here.triax("replay f/inner f/b.csv --db other.db --json").status == 0);
  fs::create_directories(here / "empty");
  const Outcome empty = here.triax("replay empty");
  CHECK(empty.status == 2);
  CHECK(holds(empty.err, "no record found"));
  CHECK_FALSE(here.has("triax.db"));
}

TEST_CASE("replay FOLDER: all tests of a file, as for the file alone") {
  const Workplace here;
  fs::create_directories(here / "f");
  write(here / "f/one.csv", kUndrained + undrained(25, 400));
  write(here / "f/two.csv", kUndrained + undrained(20, 400) + undrained(30, 500));
  // The second test begins in rows that are not among the first and last thousand.
  write(here / "f/late.csv", kUndrained + undrained(1500, 400, 0.01) + undrained(1500, 500, 0.01));
  const Outcome first = here.triax("replay f");
  INFO(first.out << first.err);
  CHECK(first.status == 0);
  CHECK(holds(first.out, "3 files: 3 stored, 0 read before, 0 failed, 0 no records"));
  CHECK(holds(first.out, "1 to 2"));
  CHECK(holds(first.out, "4 to 5"));
  const json tests = document_of(here, "report 1 2 3 4 5 --format json");
  std::vector<int> readings;
  for (const json& test : tests) readings.push_back(test["test"]["readings"].get<int>());
  CHECK(readings == std::vector<int>{1500, 1500, 25, 20, 30});
  const json alone = document_of(here, "replay f/two.csv --db alone.db --json");
  CHECK(alone[1]["test"]["digest"] == tests[4]["test"]["digest"]);

  CHECK(holds(here.triax("replay f").out, "3 files: 0 stored, 3 read before"));
  // The tests of a file that are missing are read.
  CHECK(here.triax("tests remove 4").status == 0);
  const Outcome again = here.triax("replay f --json");
  CHECK(json::parse(again.out)["test"]["readings"] == 20);
}

TEST_CASE("replay FOLDER: a fault in one of several tests fails the file") {
  const Workplace here;
  fs::create_directories(here / "f");
  write(here / "f/x.csv", kUndrained + undrained(20, 400) + undrained(250, 500));
  const Outcome outcome = here.triax("replay f");
  INFO(outcome.out << outcome.err);
  CHECK(outcome.status == 2);
  CHECK(holds(outcome.err, "1 of 2 tests could not be read: line "));
  CHECK(document_of(here, "report 1 --format json")["test"]["readings"] == 20);
}

TEST_CASE("replay --watch: a grown file replaces all tests of its first part") {
  const Workplace here;
  fs::create_directories(here / "f");
  const Running watch(here, "replay f --watch");
  const std::string part = kUndrained + undrained(20, 400) + undrained(15, 500);
  write(here / "f/x.csv", part);
  REQUIRE(says(watch, "x.csv: tests 1 to 2, "));
  write(here / "f/x.csv", part + undrained(10, 600));
  CHECK(says(watch, "x.csv: tests 3 to 5, "));
  CHECK(says(watch, "replaces test 1, 2, the first part of this file"));
}

TEST_CASE("replay --watch: needs one folder") {
  const Workplace here;
  fill(here);
  for (const char* arguments : {"f/a.csv --watch", "f f/inner --watch", "f --watch --json"}) {
    const Outcome outcome = here.triax("replay " + std::string(arguments));
    CHECK(outcome.status == 2);
    CHECK(holds(outcome.err, "--watch"));
  }
}

TEST_CASE("replay --watch: reads files as they come, and survives those that do not") {
  const Workplace here;
  fill(here);
  const Running watch(here, "replay f --watch --db t.db");
  CHECK(says(watch, "b.csv: test 2, "));
  CHECK(says(watch, "letter.txt: no record: "));
  // Written in pieces: read once, when it is whole.
  for (int rows = 0; rows < 4; ++rows) {
    std::ofstream(here / "f/slow.csv", std::ios::app)
        << (rows == 0 ? "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n"
                      : "0." + std::to_string(rows) + ",5,10" + std::to_string(rows) + '\n');
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
  }
  write(here / "f/bad.csv", std::string(kTable) + "0.3,x,104\n");
  write(here / "f/gone.csv", kTable);
  fs::remove(here / "f/gone.csv");
  write(here / "f/twin.csv", kTable);
  CHECK(says(watch, "slow.csv: test 3, "));
  CHECK(says(watch, "bad.csv: failed: "));
  CHECK(says(watch, "twin.csv: read before, unchanged, as test 2"));
  CHECK_FALSE(holds(watch.out(), "gone.csv"));
  write(here / "f/bad.csv", std::string(kTable) + "0.3,10,104\n");
  CHECK(says(watch, "bad.csv: test 4, "));
  {
    // Another program holds the lock; the folder is away for a moment.
    SQLite::Database locked((here / "t.db").string(), SQLite::OPEN_READWRITE);
    SQLite::Transaction lock(locked, SQLite::TransactionBehavior::IMMEDIATE);
    write(here / "f/late.csv", std::string(kTable) + "0.3,11,104\n");
    std::this_thread::sleep_for(std::chrono::seconds(4));
    CHECK_FALSE(holds(watch.out(), "late.csv"));
  }
  CHECK(says(watch, "late.csv: test 5, "));
  fs::rename(here / "f", here / "g");
  std::this_thread::sleep_for(std::chrono::seconds(1));
  fs::rename(here / "g", here / "f");
  write(here / "f/last.csv", std::string(kTable) + "0.3,12,104\n");
  CHECK(says(watch, "last.csv: test 6, "));
  // A file that grew replaces its first part, unless the user did something with that.
  write(here / "f/last.csv", std::string(kTable) + "0.3,12,104\n0.4,12.5,105\n");
  CHECK(says(watch, "last.csv: test 7, "));
  CHECK(says(watch, "replaces test 6"));
  CHECK(here.triax("tests tag 7 mine --db t.db").status == 0);
  write(here / "f/last.csv", std::string(kTable) + "0.3,12,104\n0.4,12.5,105\n0.5,13,106\n");
  CHECK(says(watch, "last.csv: test 8, "));
  CHECK_FALSE(holds(watch.out(), "replaces test 7"));
  CHECK(watch.end_by(SIGINT) == 0);
  CHECK(document_of(here, "tests --json --db t.db").size() == 7);
}
