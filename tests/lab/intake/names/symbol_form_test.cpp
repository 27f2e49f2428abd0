// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/symbol_form.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "lab/intake/names/heading_form.hpp"

using namespace triax::lab;

namespace {

std::vector<std::string> readings_of(std::string_view text) {
  std::vector<std::string> readings;
  for (const QString& reading : symbol_readings(repair_heading(text)))
    readings.push_back(reading.toStdString());
  return readings;
}

using Readings = std::vector<std::string>;

}  // namespace

TEST_CASE("symbol_readings: symbols and expressions are read") {
  CHECK(readings_of("sigma_1_eff") == Readings{"σ1'"});
  CHECK(readings_of("s'(a)") == Readings{"σ1'"});
  CHECK(readings_of("(s1-s3)/2").front() == "σ1σ3/2");
  CHECK(readings_of("eps_v").size() == 2);
  CHECK(readings_of("deltaU").front() == "δu");
  CHECK(readings_of("Cell pressure").empty());
  CHECK(readings_of("").empty());
}

TEST_CASE("symbol_readings: a hostile expression has a bounded number of readings") {
  CHECK(readings_of("t-t-t-t-t-t-t-t-t-t").size() <= 1024);
  CHECK(readings_of(std::string(1 << 16, 't')).empty());
  CHECK(readings_of(std::string(1 << 16, '(')).empty());
}
