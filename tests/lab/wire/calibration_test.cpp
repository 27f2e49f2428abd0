// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/calibration.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/base/bad_input.hpp"
#include "lab/base/toml_reader.hpp"

using namespace triax::lab;
using Catch::Matchers::Contains;

namespace {
Calibration read(const std::string& text) {
  return read_calibration(TomlTable::parse(text, "rig.toml"));
}
}  // namespace

TEST_CASE("a calibration there and back", "[calibration]") {
  const auto cell = read(
      "gain = 125\noffset = -2.5\nrange = [0, 1000]\ndate = \"2026-02-28\"\ncertificate = \"C "
      "12\"\n");
  CHECK(cell.value_of(4).value == 497.5);
  CHECK(cell.value_of(4).in_range);
  CHECK(cell.raw_of(497.5) == 4);
  CHECK(cell.date == "2026-02-28");
  CHECK(cell.certificate == "C 12");
  const auto none = read("");
  CHECK(none.value_of(3).value == 3);
  CHECK(none.raw_of(3) == 3);
}

TEST_CASE("what is outside the calibrated range is told, at its ends it is inside",
          "[calibration]") {
  const auto cell = read("gain = -2\noffset = 1\nrange = [-1, 5]\n");
  CHECK(cell.value_of(1).in_range);
  CHECK(cell.value_of(-2).in_range);
  CHECK_FALSE(cell.value_of(1.01).in_range);
  CHECK_FALSE(cell.value_of(-2.01).in_range);
  CHECK(cell.value_of(-2.01).value == Approx(5.02));
  for (const auto& one : {cell, read("")}) {
    CHECK(std::isnan(one.value_of(INFINITY).value));
    CHECK_FALSE(one.value_of(INFINITY).in_range);
    CHECK_FALSE(one.value_of(-INFINITY).in_range);
    CHECK(std::isnan(one.value_of(NAN).value));
    CHECK(one.value_of(NAN).in_range);
  }
}

TEST_CASE("a faulty calibration names its line", "[calibration]") {
  for (const auto& [text, words] : std::initializer_list<std::pair<const char*, const char*>>{
           {"gain = 0", "rig.toml:1: gain: must not be 0"},
           {"\nrange = [1]", "rig.toml:2: range: expected [MIN, MAX]"},
           {"range = [2, 1]", "expected [MIN, MAX]"},
           {"date = \"2026-02-29\"", "is not a date"},
           {"date = \"17.3.2026\"", "is not a date"},
           {"date = \"2026-03--1\"", "is not a date"},
           {"gian = 1", "did you mean 'gain'"},
           {"gian = 1", "offset, range, date"}}) {
    INFO(text);
    CHECK_THROWS_WITH(read(text), Contains(words));
    CHECK_THROWS_AS(read(text), BadInput);
  }
}

TEST_CASE("the digest tells identities and calibrations apart", "[calibration]") {
  const auto a = read("gain = 0.1"), b = read("gain = 0.1\ndate = \"2026-01-01\"");
  // printf '"maker,1"\n"cell": gain = 0.1, offset = 0\n' | sha256sum
  CHECK(instrument_digest("maker,1", {{"cell", a}}) ==
        "0da2e77f131e91df3c25d0bad1e9c336cee0e6bc2c1cf30d240fc1daab70813c");
  CHECK(instrument_digest("maker,1", {{"cell", a}, {"back", b}}) ==
        instrument_digest("maker,1", {{"back", b}, {"cell", a}}));
  CHECK(instrument_digest("maker,1", {{"cell", a}}) != instrument_digest("maker,1", {{"cell", b}}));
  CHECK(instrument_digest("maker,1", {{"cell", a}}) != instrument_digest("maker,2", {{"cell", a}}));
  CHECK(instrument_digest("maker,1", {{"cell", a}}) != instrument_digest("maker,1", {{"back", a}}));
}
