// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/chosen_test.hpp"

#include <set>
#include <string>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/rig/recorded.hpp"
#include "tests/lab/rig/rig_text.hpp"

using namespace triax::lab;
using triax::lab::test::all_readings;

namespace {

const std::string kTable =
    "Axial strain (%),Deviator stress (kPa),Cell pressure (kPa),Pore pressure (kPa)\n";

std::string undrained(int count, double cell) {
  std::string out;
  for (int i = 0; i < count; ++i)
    out += fmt::format("{:.2f},{:.1f},{:.1f},{:.1f}\n", 0.5 * i, 100.0 * i / (i + 4), cell,
                       200 + 50.0 * i / (i + 6));
  return out;
}

std::unique_ptr<RecordedRig> open_table(const std::string& text, std::size_t test) {
  RecordOptions options;
  options.test = test;
  return open_record(open_memory("m.csv", text), options);
}

}  // namespace

TEST_CASE("RecordedRig: each of several tests is a record with its own digest") {
  const std::string text = kTable + undrained(20, 300) + undrained(15, 400);
  std::set<std::string> digests;
  const std::vector<std::size_t> counts{20, 15};
  for (std::size_t test = 1; test <= 2; ++test) {
    const auto rig = open_table(text, test);
    CHECK(all_readings(*rig).size() == counts[test - 1]);
    CHECK(rig->header().name.starts_with("m, lines "));
    digests.insert(rig->header().digest);
  }
  CHECK(digests.size() == 2);
  CHECK_THROWS_WITH(open_table(text, 3), "m.csv: there is no test 3; the file has 2");
}

TEST_CASE("RecordedRig: a test that is not chosen ends where another begins") {
  const auto rig = open_table(kTable + undrained(20, 300) + undrained(15, 400), 0);
  CHECK_THROWS_AS(all_readings(*rig), SeveralTests);
}

TEST_CASE("tests_in: the tests of a file that is not on the disk") {
  const auto names_of = [](const std::string& text) {
    return tests_in([&] { return open_memory("m.csv", text); }, {}).names;
  };
  const auto names = names_of(kTable + undrained(20, 300) + undrained(15, 400));
  REQUIRE(names.size() == 2);
  CHECK(names[1] == "lines 22 to 36");
  CHECK(names_of(kTable + undrained(20, 300)).empty());
  for (const std::string& no_table :
       {std::string(), std::string(1000, '\0'), std::string("PK\3\4")})
    CHECK(names_of(no_table).empty());
}

TEST_CASE("RecordedRig: test 1 of a file with one test is the whole file") {
  const auto rig = open_table(kTable + undrained(20, 300), 1);
  CHECK(all_readings(*rig).size() == 20);
  CHECK(rig->header().name == "m");
}

TEST_CASE("RecordedRig: words of a stage column are names of stages") {
  std::string text =
      "Height (mm),76\nDiameter (mm),38\n"
      "Stufe,Zeit (s),Axialweg (mm),Axialkraft (N),Zelldruck (kPa),Porenwasserdruck (kPa)\n";
  const char* const stages[] = {"Sättigung", "Konsolidation", "Scherphase"};
  for (int i = 0; i < 60; ++i) {
    const int stage = i / 20, row = i % 20;
    text += fmt::format("{},{},{:.3f},{:.2f},{:.1f},{:.1f}\n", stages[stage], 10 * i,
                        stage == 2 ? 0.2 * row : 0.0, stage == 2 ? 300.0 * row / (row + 5) : 0.0,
                        stage == 0 ? 100 + 10.0 * row : 400.0,
                        stage == 0   ? 90 + 10.0 * row
                        : stage == 1 ? 350 - 2.0 * row
                                     : 310 + 2.0 * row);
  }
  const auto rig = open_table(text, 0);
  const auto& header = rig->header();
  REQUIRE(header.stages.size() == 3);
  CHECK(header.stages[0].name == "Sättigung");
  CHECK(header.stages[0].role == StageRole::saturation);
  CHECK(header.stages[1].role == StageRole::consolidation);
  CHECK(header.stages[2].name == "Scherphase");
  CHECK(header.stages[2].role == StageRole::shear);
  const auto readings = all_readings(*rig);
  REQUIRE(readings.size() == 60);
  CHECK(readings[19].stage == 1);
  CHECK(readings[59].stage == 3);
}

TEST_CASE("RecordedRig: an unconfined test needs no cell pressure") {
  std::string text = "Test type,UC\nAxial strain (%),Axial stress (kPa)\n";
  for (int i = 0; i < 20; ++i) text += fmt::format("{:.1f},{:.1f}\n", 0.5 * i, 80.0 * i / (i + 3));
  const auto rig = open_table(text, 0);
  CHECK(rig->header().is_unconfined());
  const auto readings = all_readings(*rig);
  REQUIRE(readings.size() == 20);
  CHECK(readings[10][Quantity::cell_pressure] == 0);
}

TEST_CASE("RecordedRig: a later test has its own labels and those common to the file") {
  const std::string text = "Specific gravity: 2.65\nTest: A\nHeight: 76 mm\nVoid ratio: 0.8\n" +
                           kTable + undrained(20, 300) + "\nTest: B\nHeight: 80 mm\n" + kTable +
                           undrained(15, 400);
  const auto first = open_table(text, 1), second = open_table(text, 2);
  CHECK(first->header().name == "A");
  CHECK(first->header().specimen.void_ratio == 0.8);
  CHECK(second->header().name == "B");
  CHECK(second->header().specimen.height_m == Approx(0.080));
  CHECK_FALSE(second->header().specimen.void_ratio);
  for (const auto* rig : {first.get(), second.get()})
    CHECK(rig->header().specimen.specific_gravity == 2.65);
  const std::string titles = "Specific gravity: 2.65\nTest 1\nVoid ratio: 0.8\n" + kTable +
                             undrained(20, 300) + "\nTest 2\nHeight: 80 mm\n" + kTable +
                             undrained(15, 400);
  const auto later = open_table(titles, 2);
  CHECK_FALSE(later->header().specimen.void_ratio);
  CHECK(later->header().specimen.specific_gravity == 2.65);
}
