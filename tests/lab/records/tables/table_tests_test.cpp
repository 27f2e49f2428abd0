// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/tables/table_tests.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "lab/records/tables/table_recognition.hpp"

using namespace triax::lab;

namespace {

const std::string kHeadings = "Axial strain (%),Deviator stress (kPa),Cell pressure (kPa)";

/// Strain, q and cell pressure of row `i` of a test.
std::string row(int i, double cell = 300) {
  return fmt::format("{:.2f},{:.1f},{:.1f}", 0.5 * i, 100.0 * i / (i + 4.0), cell);
}

std::string rows(int count, const std::string& before = "", double cell = 300) {
  std::string out;
  for (int i = 0; i < count; ++i) out += before + row(i, cell) + '\n';
  return out;
}

std::vector<std::string> names_of(const std::string& text, Extent extent = Extent::sample) {
  const auto source = open_memory("m.csv", text);
  std::vector<std::string> names;
  for (const TableTest& test : find_tests(*source, {}, extent)) names.push_back(test.name);
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("find_tests: one test has no parts") {
  CHECK(names_of(kHeadings + '\n' + rows(30)).empty());
  CHECK(names_of("").empty());
  CHECK(names_of("no table\n").empty());
  CHECK(names_of(std::string("a\0b", 3)).empty());
}

TEST_CASE("find_tests: tests below each other, with headings again or not") {
  CHECK(names_of(kHeadings + '\n' + rows(20) + rows(15)) ==
        Names{"lines 2 to 21", "lines 22 to 36"});
  CHECK(names_of(kHeadings + '\n' + rows(20) + kHeadings + '\n' + rows(15)) ==
        Names{"lines 2 to 21", "lines 23 to 37"});
}

TEST_CASE("find_tests: each test has the labels of its own lines") {
  const auto block = [](const char* height) {
    return fmt::format("Specimen height (mm),{}\nDiameter (mm),50\n\n", height) + kHeadings + '\n' +
           rows(20);
  };
  const auto source = open_memory("m.csv", block("76.2") + '\n' + block("140"));
  const auto tests = find_tests(*source, {});
  REQUIRE(tests.size() == 2);
  std::vector<Warning> warnings;
  Findings findings(warnings);
  for (const auto& [test, height] : {std::pair(tests[0], 76.2), std::pair(tests[1], 140.0)}) {
    const TableLayout layout = recognise_table(*source, {}, findings, test);
    const auto label = std::ranges::find(layout.labels, "height", &LabelValue::name);
    REQUIRE(label != layout.labels.end());
    CHECK(label->value == Approx(height));
    CHECK(std::ranges::count(layout.labels, "height", &LabelValue::name) == 1);
  }
}

TEST_CASE("find_tests: a test that goes on below its headings is one test") {
  std::string text = kHeadings + '\n';
  for (int i = 0; i < 30; ++i) text += row(i) + '\n' + (i == 14 ? kHeadings + '\n' : "");
  CHECK(names_of(text).empty());
}

TEST_CASE("find_tests: tables side by side with their titles") {
  std::string text = "Specimen 1,,,,Specimen 2,,\n" + kHeadings + ",," + kHeadings + '\n';
  for (int i = 0; i < 20; ++i) text += row(i) + (i < 15 ? ",," + row(i, 500) : ",,,,") + '\n';
  const auto source = open_memory("m.csv", text);
  const auto tests = find_tests(*source, {});
  REQUIRE(tests.size() == 2);
  CHECK(tests[0].name == "cells 1 to 3, 'Specimen 1'");
  CHECK(tests[1].name == "cells 5 to 7, 'Specimen 2'");
  std::vector<Warning> warnings;
  Findings findings(warnings);
  const TableLayout layout = recognise_table(*source, {}, findings, tests[1]);
  CHECK(layout.first_cell == 4);
  CHECK(layout.columns.front().cell == 4);
  CHECK_THROWS_AS(recognise_table(*source, {}, findings), SeveralTests);
}

TEST_CASE("find_tests: a column names the tests") {
  const std::string text =
      "Specimen," + kHeadings + '\n' + rows(12, "CU-1,") + rows(12, "CU-2,") + rows(12, "CU-3,");
  CHECK(names_of(text) ==
        Names{"lines 2 to 13, 'CU-1'", "lines 14 to 25, 'CU-2'", "lines 26 to 37, 'CU-3'"});
  std::string mixed = "Specimen," + kHeadings + '\n';
  for (int i = 0; i < 30; ++i) mixed += (i % 2 == 0 ? "A," : "B,") + row(i) + '\n';
  CHECK(names_of(mixed).empty());
}

TEST_CASE("find_tests: a restart in the middle of a long file needs all rows") {
  std::string text = kHeadings + '\n';
  for (int test = 0; test < 2; ++test)
    for (int i = 0; i < 2000; ++i)
      text += fmt::format("{:.3f},{:.2f},300.0\n", 0.01 * i, 100.0 * i / (i + 400.0));
  CHECK(names_of(text).empty());
  CHECK(names_of(text, Extent::whole) == Names{"lines 2 to 2001", "lines 2002 to 4001"});
}

TEST_CASE("find_tests: each test has its own name, and the lines below its rows") {
  std::string text = "Laboratory,North\nTest:,Quick undrained triaxial (UU)\n\n";
  for (const char* name : {"A", "B", "C"})
    text += fmt::format(
        "Specimen:,{}\nLength (mm),76.2,Diameter (mm),38.1\n{}\n{}Mode of "
        "failure:,barrel {}\n\n",
        name, kHeadings, rows(20), name);
  const auto source = open_memory("m.csv", text);
  const auto tests = find_tests(*source, {});
  REQUIRE(tests.size() == 3);
  std::vector<Warning> warnings;
  Findings findings(warnings);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string name(1, static_cast<char>('A' + i));
    const TableLayout layout = recognise_table(*source, {}, findings, tests[i]);
    const auto last = std::find_if(layout.labels.rbegin(), layout.labels.rend(),
                                   [](const LabelValue& label) { return label.name == "name"; });
    REQUIRE(last != layout.labels.rend());
    CHECK(last->text == name);
    CHECK(std::ranges::count(layout.labels, "programme", &LabelValue::name) == 1);
    CHECK(layout.head.back() == "Mode of failure:,barrel " + name);
    CHECK(std::ranges::count_if(layout.head, [](const std::string& line) {
            return line.starts_with("Mode of failure");
          }) == 1);
  }
}
