// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/diggs_table.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "tests/lab/diggs/diggs_text.hpp"

using namespace triax::lab;
using namespace triax::lab::test;

namespace {

DiggsDocument content_of(const std::string& text) {
  return read_diggs(*open_memory("f.xml", diggs(text)));
}
DiggsTable table_of(const std::string& outcome) {
  return read_result_sets(content_of(diggs_test("T", "", outcome)).tests.at(0), "f.xml");
}
DiggsTable increments(const std::string& shear) {
  return read_increments(content_of(diggs_test("T", trial("s", shear))).tests.at(0).trials.at(0),
                         "f.xml");
}

}  // namespace

TEST_CASE("read_result_sets: numbers keep their digits and units") {
  const auto table = table_of(
      result_set({"time|time|min", "a|axial_strain|%", "q|deviator_stress|kPa", "T|heat|degC"},
                 "0,0,0.1,20\n0.5,0.1,33.333333333333336,21\n"));
  CHECK(table.text() ==
        "time_min,axial_strain_%,deviator_stress_kPa\n0,0,0.1\n0.5,0.1,33.333333333333336\n");
  REQUIRE(table.warnings.size() == 1);
  CHECK(table.warnings[0].text == "properties that are not used: 'T'");
}

TEST_CASE("read_result_sets: single results are no readings") {
  CHECK(table_of(result_set({"c|shear_strength_undrained|kPa"}, "145")).count == 0);
  CHECK(table_of(result_set({"e|axial_strain|%", "q|deviator_stress|kPa"}, "2,145")).count == 0);
  CHECK(table_of("").count == 0);
}

TEST_CASE("read_result_sets: null values, decimal comma, missing values") {
  const auto text = result_set({"e|axial_strain|", "q|deviator_stress|kPa"},
                               "0;1,5\n0,1;NaN\n0,2;-999\n0,3;", "cs=\";\" decimal=\",\"");
  const auto with_null = [&] {
    std::string changed = text;
    changed.insert(changed.rfind("</Property>"), "<nullValue>-999</nullValue>");
    return changed;
  }();
  CHECK(table_of(with_null).rows == "0,1.5\n0.1,\n0.2,\n0.3,\n");
}

TEST_CASE("read_result_sets: a bad value names line and property") {
  const auto fault = [](const std::string& unit, const std::string& values) {
    try {
      table_of(result_set({"e|axial_strain|%", "load|axial_force|" + unit}, values));
    } catch (const BadInput& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  CHECK(fault("kN", "0,1\n1,x") == "f.xml:9: property 'load' = 'x' is not a number");
  CHECK(fault("kN", "0,1\n1,inf") == "f.xml:9: property 'load' = 'inf' is not a number");
  CHECK_THAT(fault("stone", "0,1\n1,2"), Catch::Contains("unknown unit of measure"));
  CHECK_THAT(fault("kPa", "0,1\n1,2"), Catch::Contains("is in 'kPa'; expected a unit like kN"));
  CHECK_THAT(fault("kN", "0,1\n1"), Catch::Contains("f.xml:9: a tuple of dataValues has 1 value"));
}

TEST_CASE("read_increments: total stresses and the cell pressure of the stage") {
  const auto table = increments(increment(0, 0, 200) + increment(30, 0.5, 210) + kCellPressure);
  CHECK(table.text() ==
        "deviator_stress_kPa,axial_strain,pore_pressure_kPa,cell_pressure_kPa\n"
        "0,0,200,300\n30,0.005,210,300\n");
  CHECK(table.warnings.empty());
}

TEST_CASE("read_increments: an induced pore pressure is added to the start") {
  const auto induced = [](double q, double u) {
    return fmt::format(
        "<geo:shearingIncrement><geo:ShearingIncrement>"
        "<geo:deviatorStress uom=\"kPa\">{}</geo:deviatorStress>"
        "<geo:axialStrain uom=\"%\">1</geo:axialStrain>"
        "<geo:inducedPoreWaterPressure uom=\"kPa\">{}</geo:inducedPoreWaterPressure>"
        "</geo:ShearingIncrement></geo:shearingIncrement>",
        q, u);
  };
  const auto rows = induced(0, 0) + induced(10, 5);
  const std::string start =
      "<geo:porewaterPressureStartOfShearing uom=\"kPa\">200"
      "</geo:porewaterPressureStartOfShearing>";
  CHECK(increments(start + rows).rows == "0,0.01,200\n10,0.01,205\n");
  const auto unknown = increments(rows);
  CHECK(unknown.has(Quantity::excess_pore_pressure));
  CHECK_FALSE(unknown.has(Quantity::pore_pressure));
  const auto back = increments(
      "<geo:maximumBackPressureApplied uom=\"kPa\">100"
      "</geo:maximumBackPressureApplied>" +
      rows);
  CHECK(back.rows == "0,0.01,100\n10,0.01,105\n");
  CHECK(back.warnings.size() == 1);
}

TEST_CASE("read_increments: a cell pressure that is not repeated is carried on") {
  const std::string cell = "<geo:totalCellPressure uom=\"bar\">3</geo:totalCellPressure>";
  const auto table = increments(increment(0, 0, 200, cell) + increment(30, 0.5, 210));
  CHECK(table.rows == "0,0,200,300\n30,0.005,210,300\n");
  REQUIRE(table.warnings.size() == 1);
  CHECK_THAT(table.warnings[0].text, Catch::Contains("totalCellPressure is missing"));
}

TEST_CASE("read_increments: a bad unit names the line of the element") {
  CHECK_THROWS_WITH(
      increments(increment(0, 0, 200) +
                 increment(1, 1, 200, "<geo:elapsedTime uom=\"kPa\">1</geo:elapsedTime>")),
      "f.xml:7: elapsedTime is in 'kPa'; expected a unit like s");
  CHECK(increments("").count == 0);
}
