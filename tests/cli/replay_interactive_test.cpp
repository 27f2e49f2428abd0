// SPDX-License-Identifier: GPL-3.0-or-later
// triax replay --interactive with answers from a pipe.
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;
using nlohmann::json;

namespace {

constexpr const char* kOpenTime =
    "Time,Strain (%),q (kPa),u (kPa)\n0,0,0,200\n1,0.5,50,220\n2,1,80,240\n3,2,100,255\n"
    "4,3,110,262\n5,4,112,265\n";
constexpr const char* kRaw =
    "Time (s),Displacement (mm),Load (kN),Cell pressure (kPa),Pore pressure (kPa)\n"
    "0,0,0,300,200\n10,0.5,0.1,300,220\n20,1,0.15,300,240\n30,1.5,0.18,300,250\n"
    "40,2,0.2,300,255\n50,3,0.21,300,258\n";
constexpr const char* kComplete =
    "Time (s),Strain (%),q (kPa),p' (kPa),u (kPa)\n0,0,0,100,200\n10,0.5,50,96.7,220\n"
    "20,1,80,86.7,240\n30,2,100,78.3,255\n40,3,110,74.7,262\n50,4,112,72.3,265\n";
constexpr const char* kDates =
    "Clock,Strain (%),q (kPa),p' (kPa),u (kPa)\n03/04/2026 10:00,0,0,100,200\n"
    "03/04/2026 10:01,0.5,50,96.7,220\n03/04/2026 10:02,1,80,86.7,240\n"
    "03/04/2026 10:03,2,100,78.3,255\n03/04/2026 10:04,3,110,74.7,262\n";

bool shows(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Outcome talk(const Workplace& here, const std::string& table, const std::string& answers) {
  write(here / "x.csv", table);
  Outcome outcome = here.triax("replay x.csv --interactive", answers);
  UNSCOPED_INFO(outcome.out << outcome.err);
  return outcome;
}

/// Values of the only stored test.
json result_of(const Workplace& here) {
  const Outcome shown = here.triax("report 1 --format json");
  REQUIRE(shown.status == 0);
  return json::parse(shown.out);
}

void check_nothing_stored(const Workplace& here, const Outcome& outcome) {
  CHECK(outcome.status == 2);
  CHECK(shows(outcome.err, "nothing was read or stored"));
  CHECK_FALSE(here.has("triax.db"));
  CHECK_FALSE(here.has("x.toml"));
}

}  // namespace

TEST_CASE("replay --interactive: a table without questions is read with one Enter") {
  const Workplace here;
  const Outcome outcome = talk(here, kComplete, "\n");
  CHECK(outcome.status == 0);
  CHECK(shows(outcome.out, "axial_strain"));
  CHECK(shows(outcome.out, "0, 0.5, 1"));
  CHECK(shows(outcome.out, "112.0 kPa at 4.00 %"));
  CHECK(shows(outcome.out, "[Y/n/s]"));
  CHECK(here.has("triax.db"));
}

TEST_CASE("replay --interactive: unit of time and cell pressure are asked") {
  const Workplace here;
  const Outcome outcome = talk(here, kOpenTime, "2\n300\ny\n");
  CHECK(outcome.status == 0);
  CHECK(shows(outcome.out, "unit of column 1 'Time'"));
  CHECK(shows(outcome.out, "held cell pressure"));
  CHECK(shows(outcome.out, "300.0 s from the first to the last"));
  CHECK(shows(outcome.out, "100.0 kPa"));
  CHECK(here.has("triax.db"));
}

TEST_CASE("replay --interactive: Enter accepts usual units, but not the test") {
  const Workplace here;
  const Outcome outcome = talk(here, kOpenTime, "\n300\n\n");
  CHECK(shows(outcome.out, "[y/N/s]"));
  check_nothing_stored(here, outcome);
}

TEST_CASE("replay --interactive: the unit of a force has to be typed") {
  const Workplace here;
  std::string table = kRaw;
  table.replace(table.find("Load (kN)"), 9, "Axial force");
  const Outcome outcome = talk(here, table, "\n\nkN\n100\n50\ny\n");
  CHECK(outcome.status == 0);
  CHECK(shows(outcome.out, "does not contain this unit"));
  CHECK_FALSE(shows(outcome.out, "answer []"));
  CHECK(shows(outcome.out, "0.00 % to 3.00 %"));
}

TEST_CASE("replay --interactive: Enter reads strains and stresses without dimensions") {
  const Workplace here;
  const Outcome outcome = talk(here,
                               "Test type,UC\n\nTime (min),Load (N),Strain (%),q (kPa)\n"
                               "0,0,0,0\n1,68,0.66,59.6\n2,100,1.32,87.0\n3,120,1.97,103.7\n",
                               "\ny\n");
  CHECK(outcome.status == 0);
  CHECK(shows(outcome.out, "such as 38, or Enter to read it without"));
  CHECK(shows(outcome.out, "51.9 kPa"));
  CHECK(here.has("triax.db"));
}

TEST_CASE("replay --interactive: height and diameter are asked until they are typed") {
  const Workplace here;
  const Outcome outcome = talk(here, kRaw, "100\n\n50\ny\n");
  CHECK(outcome.status == 0);
  CHECK(shows(outcome.out, "answer in mm, such as 76"));
  CHECK(shows(outcome.out, "answer in mm, such as 50"));
  CHECK(shows(outcome.out, "does not contain this value"));
  CHECK(shows(outcome.out, "0.00 % to 3.00 %"));
}

TEST_CASE("replay --interactive: values of --set are not asked for") {
  const Workplace here;
  write(here / "x.csv", kRaw);
  const Outcome outcome = here.triax(
      "replay x.csv --interactive --set specimen.height_cm=10 --set specimen.diameter_mm=50", "\n");
  CHECK(outcome.status == 0);
  CHECK_FALSE(shows(outcome.out, "answer in mm"));
  write(here / "x.toml", "[specimen]\nheight_mm = 100\ndiameter_mm = 50\n");
  CHECK_FALSE(shows(here.triax("replay x.csv --interactive", "\n").out, "answer in mm"));
  CHECK(shows(outcome.out, "0.00 % to 3.00 %"));
}

TEST_CASE("replay --interactive: s' and t are one question") {
  const Workplace here;
  const Outcome outcome =
      talk(here,
           "Strain (%),q (kPa),p' (kPa),u (kPa)\n0,0,150,200\n0.5,30.9,149.5,231.4\n"
           "1,42.25,140.25,252\n2,48.2,136.9,261.3\n4,52,137.9,264.1\n",
           "?\n2\ny\n");
  CHECK(outcome.status == 0);
  CHECK(shows(outcome.out, "friction angle depends on the answer"));
  CHECK(shows(outcome.out, "104.0 kPa at 4.00 %"));
}

TEST_CASE("replay --interactive: columns without headings are named") {
  const Workplace here;
  const std::string rows =
      "0,0,100,200\n0.5,50,96.7,220\n1,80,86.7,240\n2,100,78.3,255\n3,110,74.7,262\n";
  const Outcome outcome = talk(here, rows, "axial strain\n4\np'\nu\n\n\n\n\ny\n");
  CHECK(shows(outcome.out, "quantity of column 4"));
  CHECK(shows(outcome.out, "110.0 kPa at 3.00 %"));
  CHECK(outcome.status == 0);
}

TEST_CASE("replay --interactive: a file with several tests is read with one conversation") {
  const Workplace here;
  std::string below = kOpenTime;
  below += "0,0,0,200\n1,0.5,50,220\n2,1,80,240\n3,2,100,255\n4,3,110,262\n5,4,115,265\n";
  const Outcome outcome = talk(here, below, "1\n300\ny\n");
  CHECK(outcome.status == 0);
  CHECK(shows(outcome.out, "The file has 2 tests"));
  CHECK(shows(here.triax("report 2 --format json").out, "\"readings\": 6"));
}

TEST_CASE("replay --interactive: answers for one of tables side by side hold for all") {
  const Workplace here;
  std::string beside;
  std::istringstream lines(kOpenTime);
  for (std::string line; std::getline(lines, line);) beside += line + ",," + line + '\n';
  const Outcome outcome = talk(here, beside, "2\n1\n300\ny\n");
  CHECK(outcome.status == 0);
  CHECK(shows(outcome.out, "Shown is test 2"));
  CHECK(shows(here.triax("report 2 --format json").out, "\"readings\": 6"));
}

TEST_CASE("replay --interactive: the factor of a proving ring is asked") {
  const Workplace here;
  const std::string ring =
      "Time (s),Dial gauge (mm),Proving ring (div),Cell pressure (kPa),Pore pressure (kPa)\n"
      "0,0,0,300,200\n10,0.5,40,300,220\n20,1,60,300,240\n30,1.5,72,300,250\n"
      "40,2,80,300,255\n50,3,84,300,258\n";
  const Outcome outcome = talk(here, ring, "?\n0\n2.5\n100\n50\ns\n");
  CHECK(outcome.status == 0);
  CHECK(shows(outcome.out, "readings of a proving ring"));
  CHECK(shows(outcome.out, "0 is no factor"));
  CHECK(
      shows(content(here / "x.toml"), "axial_force = { column = 3, unit = \"N\", factor = 2.5 }"));
}

TEST_CASE("replay --interactive: order of day and month") {
  const Workplace here;
  const Outcome outcome = talk(here, kDates, "?\nmonth first\ns\n");
  CHECK(outcome.status == 0);
  CHECK(shows(outcome.out, "fit both orders"));
  CHECK(shows(content(here / "x.toml"), "date_order = \"month first\""));
}

TEST_CASE("replay --interactive: the sign of a volume is asked") {
  const Workplace here;
  const Outcome outcome = talk(here,
                               "Time (s),Axial strain (%),Volume change (cm3),q (kPa),"
                               "p' (kPa),u (kPa)\n0,0,0,0,100,200\n10,0.5,0,50,96.7,220\n"
                               "20,1,0,80,86.7,240\n30,2,0,100,78.3,255\n40,3,0,110,74.7,262\n",
                               "2\n\n\ny\n");
  CHECK(shows(outcome.out, "sign of column 3 'Volume change (cm3)'"));
  CHECK(shows(outcome.out, "water out is negative"));
}

TEST_CASE("replay --interactive: wrong answers are named and asked for again") {
  const Workplace here;
  const Outcome outcome =
      talk(here, kOpenTime, "mni\n99\n?\nc 9\nmin\nmany\n-1\nc x\n300\nperhaps\ny\n");
  CHECK(outcome.status == 0);
  CHECK(shows(outcome.out, "'mni' is no unit of this column"));
  CHECK(shows(outcome.out, "the table has no column 9"));
  CHECK(shows(outcome.out, "'many' is no number"));
  CHECK(shows(outcome.out, "'perhaps' is no answer"));
}

TEST_CASE("replay --interactive: a column is corrected") {
  const Workplace here;
  const Outcome outcome = talk(here, kComplete, "c 1\nnot used\ny\n");
  CHECK(outcome.status == 0);
  CHECK(shows(outcome.out, "no column of time"));
  const Outcome broken = talk(here, kComplete, "c 3\ntemperature\n\nq\n");
  CHECK(broken.status == 2);
  CHECK(shows(broken.out, "the file cannot be read"));
}

TEST_CASE("replay --interactive: end of input, q and n store nothing") {
  const Workplace here;
  for (const char* answers : {"", "q\n", "2\n", "2\n300\n", "2\n300\nn\n", "2\n300\nq\n", "2"})
    check_nothing_stored(here, talk(here, kOpenTime, answers));
  check_nothing_stored(here, talk(here, kComplete, "n\n"));
}

TEST_CASE("replay --interactive: a saved dialect reads the file without questions") {
  const Workplace here;
  CHECK(talk(here, kOpenTime, "min\n300\ns\n").status == 0);
  const json first = result_of(here);
  std::filesystem::remove(here / "triax.db");
  CHECK(here.triax("replay x.csv").status == 0);
  CHECK(result_of(here)["collapse"] == first["collapse"]);
}

TEST_CASE("replay --interactive: a file is replaced only if the user agrees") {
  const Workplace here;
  write(here / "x.toml", "# mine\n");
  CHECK(talk(here, kOpenTime, "min\n300\ns\n\nq\n").status == 2);
  CHECK(content(here / "x.toml") == "# mine\n");
  CHECK(talk(here, kOpenTime, "min\n300\ns\ny\n").status == 0);
  CHECK(shows(content(here / "x.toml"), "[columns]"));
}

TEST_CASE("replay --interactive: a record of triax keeps its metadata") {
  const Workplace here;
  write(here / "x.csv", content(source("samples/records/icu_6.csv")));
  const Outcome outcome = here.triax("replay x.csv --interactive", "\n");
  CHECK(outcome.status == 0);
  CHECK(shows(outcome.out, "stage 5 shear undrained"));
}

TEST_CASE("replay --interactive: hostile headings and answers are printed safely") {
  const Workplace here;
  const std::string table =
      "Time,Strain (%),\"q \x1b[2J\xe2\x80\xae (kPa)\",u (kPa),\xff\x07\n0,0,0,200,1\n"
      "1,0.5,50,220,2\n2,1,80,240,3\n3,2,100,255,4\n4,3,110,262,5\n";
  const Outcome outcome =
      talk(here, table, std::string("\x1b[31m\xff\n\0x\n", 10) + std::string(100'000, 'x') + "\n");
  CHECK(outcome.status == 2);
  CHECK_FALSE(shows(outcome.out, "\x1b["));
  CHECK_FALSE(shows(outcome.out, "\xe2\x80\xae"));
  CHECK_FALSE(shows(outcome.out, "\x07"));
}

TEST_CASE("replay --interactive: needs one table and a reader") {
  const Workplace here;
  write(here / "x.csv", kComplete);
  write(here / "letter.txt", "Dear client,\nhere are the records.\n");
  for (const char* wrong :
       {"x.csv x.csv --interactive", ". --interactive", "none.csv --interactive",
        "letter.txt --interactive", "x.csv --interactive --format json",
        "x.csv --interactive --dialect triax", "x.csv --interactive --propose"}) {
    INFO(wrong);
    CHECK(here.triax(std::string("replay ") + wrong, "\n").status != 0);
    CHECK_FALSE(here.has("triax.db"));
  }
}

TEST_CASE("replay --interactive: the kind of a test without pore pressure is asked") {
  const Workplace here;
  const std::string table =
      "Strain (%),q (kPa),Cell pressure (kPa)\n0,0,100\n0.5,50,100\n1,80,100\n2,100,100\n"
      "3,110,100\n";
  const Outcome total = talk(here, table, "1\ny\n");
  CHECK(total.status == 0);
  CHECK(shows(total.out, "total stresses, UU"));
  const Outcome drained = talk(here, table, "drained\ny\n");
  CHECK(drained.status == 0);
  CHECK(shows(drained.out, "100.0 kPa"));
}

TEST_CASE("replay --interactive: a pressure above the table is held or asked for") {
  const Workplace here;
  const std::string rows = kOpenTime;
  const std::string table = "Time (s)" + rows.substr(rows.find(','));
  const Outcome total = talk(here, "Cell pressure (kPa),300,,\n" + table, "\n");
  CHECK(total.status == 0);
  CHECK(shows(total.out, "p' at the start  100.0 kPa"));
  const Outcome effective = talk(here, "Cell pressure (kPa),150,,\n" + table, "350\ny\n");
  CHECK(effective.status == 0);
  CHECK(shows(effective.out, "answer in kPa, such as 350"));
  CHECK(shows(effective.out, "p' at the start  150.0 kPa"));
}
