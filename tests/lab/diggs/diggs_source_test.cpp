// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/diggs_source.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/base/digest.hpp"
#include "lab/rig/recorded.hpp"
#include "tests/lab/diggs/diggs_text.hpp"

using namespace triax::lab;
using namespace triax::lab::test;

namespace {

std::string shear(int readings) {
  std::string text;
  for (int i = 0; i < readings; ++i) text += increment(10 * i, 0.25 * i, 200 + i);
  return text + kCellPressure;
}

std::unique_ptr<RecordedRig> open(const std::string& content, std::size_t number = 0,
                                  const std::string& name = "f.xml") {
  RecordOptions options;
  options.test = number;
  return open_record(open_memory(name, diggs(content)), options);
}

std::vector<Reading> readings(RecordedRig& rig) {
  std::vector<Reading> all;
  Reading reading;
  while (rig.next(reading)) all.push_back(reading);
  return all;
}

const std::string kTwoTrials = diggs_test(
    "Series",
    specimen("a",
             "<diameter uom=\"in\">2.8</diameter><height uom=\"cm\">14</height>"
             "<voidRatio>0.8</voidRatio><dryWeight uom=\"gf\">850</dryWeight>") +
        specimen("b", "<diameter uom=\"mm\">70</diameter><height uom=\"mm\">141</height>") +
        "<geo:triaxialTestType>CIUC</geo:triaxialTestType>" + trial("a", shear(5)) +
        trial("b", shear(7)));

}  // namespace

TEST_CASE("a DIGGS test is a record with specimen, type and shear stage") {
  const auto rig = open(kTwoTrials, 1);
  const RecordHeader& header = rig->header();
  CHECK(header.name == "Series, trial 1");
  CHECK(header.dialect == "diggs");
  CHECK(header.programme == "CIUC");
  CHECK(*header.specimen.height_m == Approx(0.14));
  CHECK(*header.specimen.diameter_m == Approx(0.07112));
  CHECK(*header.specimen.void_ratio == 0.8);
  CHECK(*header.specimen.dry_mass_kg == 0.85);
  REQUIRE(header.stages.size() == 1);
  CHECK(header.stages[0].role == StageRole::shear);
  CHECK(header.stages[0].drainage == Drainage::closed);
  const auto all = readings(*rig);
  REQUIRE(all.size() == 5);
  CHECK(all[4][Quantity::deviator_stress] == 40e3);
  CHECK(all[4][Quantity::axial_strain] == 0.01);
  CHECK(all[4][Quantity::cell_pressure] == 300e3);
}

TEST_CASE("each trial of a DIGGS test is a record with a digest of its own") {
  const auto first = open(kTwoTrials, 1), second = open(kTwoTrials, 2);
  CHECK(*second->header().specimen.height_m == Approx(0.141));
  CHECK(readings(*second).size() == 7);
  CHECK(first->header().digest != second->header().digest);
  CHECK_THROWS_WITH(open(kTwoTrials),
                    Catch::Contains("2 tests in one file (Series, trial 1, Series, trial 2)"));
  CHECK_THROWS_AS(open(kTwoTrials, 3), BadInput);
}

TEST_CASE("a DIGGS file with one test has the digest of the file") {
  const auto text = diggs_test("One", trial("s", shear(4)));
  CHECK(open(text)->header().digest == sha256(*open_memory("f.xml", diggs(text))));
}

TEST_CASE("references of a DIGGS test become notes of the record") {
  const auto rig = open(
      "<samplingFeature><Borehole gml:id=\"b\"><gml:name>B-7</gml:name></Borehole>"
      "</samplingFeature>" +
      diggs_test("One", trial("s", shear(4)),
                 "<samplingFeatureRef xlink:href=\"#b\"/><outcome><TestResult><location>"
                 "<PointLocation><gml:pos srsDimension=\"2\">33 -118</gml:pos></PointLocation>"
                 "</location></TestResult></outcome>"));
  REQUIRE(rig->header().notes.size() == 1);  // a position on a map is no depth
  CHECK(rig->header().notes[0].label == "Borehole");
  CHECK(rig->header().notes[0].text == "B-7");
}

TEST_CASE("values of a DIGGS specimen that are impossible are ignored") {
  const auto rig = open(diggs_test(
      "One", specimen("s", "<height uom=\"mm\">0</height><diameter uom=\"kPa\">7</diameter>") +
                 trial("s", shear(4))));
  CHECK_FALSE(rig->header().specimen.height_m);
  CHECK_FALSE(rig->header().specimen.diameter_m);
  int ignored_count = 0;
  for (const Warning& warning : rig->header().warnings)
    ignored_count += warning.text.find("is not valid and ignored") != std::string::npos ? 1 : 0;
  CHECK(ignored_count == 2);
}

TEST_CASE("parameters with keys of triax are metadata") {
  const auto parameter = [](const std::string& name, const std::string& value) {
    return "<otherTestProperty><Parameter><parameterName>" + name +
           "</parameterName><parameterValue>" + value +
           "</parameterValue></Parameter></otherTestProperty>\n";
  };
  const auto rig = open(diggs_test("One", parameter("triax test.programme", "ICU") +
                                              parameter("triax stages.1.role", "shear") +
                                              parameter("triax stages.1.drainage", "open") +
                                              parameter("colour", "grey") + trial("s", shear(4))));
  CHECK(rig->header().programme == "ICU");
  CHECK(rig->header().stages.at(0).drainage == Drainage::open);
  CHECK_THROWS_WITH(
      open(diggs_test("One", parameter("triax stages.1.role", "running") + trial("s", shear(4)))),
      Catch::Contains("f.xml:5: stages.1.role = 'running' is not valid"));
}

TEST_CASE("a DIGGS file without readings or triaxial tests is refused") {
  CHECK_THROWS_WITH(open(diggs_test("One", "")),
                    Catch::Contains("f.xml:3: triaxial test 'One' has no readings, only results"));
  CHECK_THROWS_WITH(open("<measurement><Test><procedure><geo:WaterContentTest/></procedure>"
                         "</Test></measurement>"),
                    "f.xml: DIGGS without a triaxial test; it has WaterContentTest");
  CHECK_THROWS_WITH(open(""), Catch::Contains("it has no test procedure"));
  RecordOptions options;
  options.dialect = "gdslab";
  CHECK_THROWS_WITH(open_record(open_memory("f.xml", diggs("")), options),
                    Catch::Contains("leave --dialect and --sheet out"));
}

TEST_CASE("a DIGGS file with thousands of tests is refused") {
  std::string trials;
  for (int i = 0; i < 2001; ++i) trials += trial("s", "");
  CHECK_THROWS_WITH(open(diggs_test("One", trials)),
                    "f.xml: 2001 triaxial tests in one file; expected at most 2000");
}

TEST_CASE("drainage_of_type: codes of AGS and DIGGS") {
  for (const char* const type : {"CU", "CUM", "CIUC", "CAUE", "CK0U", "UU", "UUM", "UNC", "CIU"})
    CHECK(drainage_of_type(type) == Drainage::closed);
  for (const char* const type : {"CD", "CDM", "CIDC", "CADE", "CK0D"})
    CHECK(drainage_of_type(type) == Drainage::open);
  for (const char* const type : {"", "C", "CI", "triaxial"})
    CHECK(drainage_of_type(type) == Drainage::unknown);
}
