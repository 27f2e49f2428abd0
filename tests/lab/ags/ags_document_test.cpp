// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/ags_document.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("a document is written in quotes with CR LF, and read back it gives the same bytes") {
  AgsDocument document;
  document.tables.push_back({"PROJ", {{"PROJ_ID", "", "ID"}, {"PROJ_NAME", "", "X"}}, {}});
  document.tables[0].rows.push_back({"7", "a \"quote\", a comma; and  blanks "});
  document.tables.push_back({"SAMP", {{"SAMP_TOP", "m", "2DP"}}, {{"1.50"}, {""}}});
  const auto text = ags_text(document);
  CHECK(text ==
        "\"GROUP\",\"PROJ\"\r\n\"HEADING\",\"PROJ_ID\",\"PROJ_NAME\"\r\n\"UNIT\",\"\",\"\"\r\n"
        "\"TYPE\",\"ID\",\"X\"\r\n\"DATA\",\"7\",\"a \"\"quote\"\", a comma; and  blanks \"\r\n\r\n"
        "\"GROUP\",\"SAMP\"\r\n\"HEADING\",\"SAMP_TOP\"\r\n\"UNIT\",\"m\"\r\n\"TYPE\",\"2DP\"\r\n"
        "\"DATA\",\"1.50\"\r\n\"DATA\",\"\"\r\n\r\n");
  const auto again = read_ags_document(*open_memory("x.ags", text));
  CHECK(ags_text(again) == text);
  REQUIRE(again.find("SAMP") != nullptr);
  CHECK(again.find("SAMP")->rows.size() == 2);
  CHECK(again.find("TREG") == nullptr);
}

TEST_CASE("text becomes ASCII: signs of the field spelled out, nothing left over") {
  CHECK(ags_ascii("Bohrprobe Ä 5°, ε₁ ≥ 2 %") == "Bohrprobe Ae 5 deg, eps1 >= 2 %");
  CHECK(ags_ascii("a\r\nb\x7F") == "a  b ");
  CHECK(ags_ascii("水\xC3") == "??");
}
