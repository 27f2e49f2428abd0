// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/diggs_document.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "tests/lab/diggs/diggs_text.hpp"

using namespace triax::lab;
using namespace triax::lab::test;

namespace {

DiggsDocument document_of(const std::string& text) {
  return read_diggs(*open_memory("f.xml", text));
}
bool is_diggs(const std::string& text, const std::string& name = "f.xml") {
  return looks_like_diggs(*open_memory(name, text));
}

}  // namespace

TEST_CASE("looks_like_diggs: the root element decides") {
  CHECK(is_diggs(diggs("")));
  CHECK(is_diggs("\xEF\xBB\xBF\n" + diggs("").substr(39)));
  CHECK(is_diggs("<a:Diggs xmlns:a=\"x\"/>"));
  CHECK(is_diggs("<broken", "f.diggs"));
  CHECK(is_diggs("<!DOCTYPE Diggs><Diggs/>"));
  CHECK_FALSE(is_diggs("<gpx/>"));
  CHECK_FALSE(is_diggs("<broken"));
  CHECK_FALSE(is_diggs("time,stage\n1,2\n", "f.diggs"));
  CHECK_FALSE(is_diggs(""));
  CHECK_FALSE(is_diggs(std::string(10, '\0')));
}

TEST_CASE("read_diggs: names of project, location and sample are resolved") {
  const auto document = document_of(diggs(
      "<project><Project gml:id=\"p\"><gml:name>Dam</gml:name><role><Role>"
      "<rolePerformed>Client</rolePerformed><businessAssociate><BusinessAssociate>"
      "<gml:name>Owner</gml:name></BusinessAssociate></businessAssociate></Role></role>"
      "</Project></project>"
      "<samplingFeature><Borehole gml:id=\"b\"><gml:name>B-7</gml:name></Borehole>"
      "</samplingFeature>" +
      diggs_test("T", "<geo:triaxialTestType>CIUC</geo:triaxialTestType>",
                 "<projectRef xlink:href=\"#p\"/><samplingFeatureRef xlink:href=\"b\"/>"
                 "<sampleRef xlink:title=\"S 3\"/><outcome><TestResult><location><PointLocation>"
                 "<gml:pos srsDimension=\"1\">4.5</gml:pos></PointLocation></location></TestResult>"
                 "</outcome>")));
  REQUIRE(document.tests.size() == 1);
  const DiggsTest& one = document.tests[0];
  CHECK(one.name == "T");
  CHECK(one.type == "CIUC");
  CHECK(one.project == "Dam");
  CHECK(one.client == "Owner");
  CHECK(one.location == "B-7");
  CHECK(one.sample == "S 3");
  CHECK(one.depth.text == "4.5");
  CHECK(one.line == 3);
}

TEST_CASE("read_diggs: other procedures are counted, not kept") {
  const auto document = document_of(
      diggs("<measurement><Test><procedure><geo:AtterbergLimitsTest/></procedure></Test>"
            "</measurement><measurement><Test><procedure><geo:AtterbergLimitsTest/></procedure>"
            "</Test></measurement>"));
  CHECK(document.tests.empty());
  CHECK(document.other_procedures.at("AtterbergLimitsTest") == 2);
}

TEST_CASE("read_diggs: hostile XML is one message with its line") {
  CHECK_THROWS_WITH(document_of("<!DOCTYPE Diggs [<!ENTITY a \"aa\">]>\n<Diggs>&a;</Diggs>"),
                    Catch::Contains("f.xml:1: its XML declares a document type"));
  CHECK_THROWS_WITH(document_of("<Diggs>\n<a>\n</b></Diggs>"),
                    Catch::Contains("f.xml:3: its XML is broken"));
  CHECK_THROWS_WITH(document_of("<Diggs>\n"), Catch::Contains("its XML is broken"));
  CHECK_THROWS_WITH(document_of(""), Catch::Contains("its XML is broken"));
  CHECK_THROWS_WITH(document_of(std::string("<Diggs>\0</Diggs>", 16)),
                    Catch::Contains("f.xml:1: "));
  std::string deep = "<Diggs>";
  for (int i = 0; i < 200; ++i) deep += "<a>";
  CHECK_THROWS_WITH(document_of(deep), Catch::Contains("nested too deep"));
  CHECK_THROWS_WITH(document_of("<Diggs><a>" + std::string(2 << 20, 'x') + "</a></Diggs>"),
                    Catch::Contains("the text of element 'a' is longer than 1 MB"));
}

TEST_CASE("read_diggs: elements outside their place do nothing") {
  CHECK(document_of("<Diggs><ShearingIncrement/><Property/><Parameter/><dataValues>1</dataValues>"
                    "<TriaxialTest/><specimenRef href=\"#x\"/><sampleRef/></Diggs>")
            .tests.empty());
  const auto document =
      document_of(diggs(diggs_test("T",
                                   "<Property/><geo:ShearingIncrement/><specimenRef/>"
                                   "<SoilSpecimen><sampleRef/></SoilSpecimen>"
                                   "<Parameter><parameterValue/></Parameter>")));
  CHECK(document.tests.size() == 1);
}
