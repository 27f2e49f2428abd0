// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/json_parts.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <numbers>

using namespace triax::study;

TEST_CASE("what is unknown, infinite or no number is null") {
  CHECK(json_number(1.5) == 1.5);
  for (const auto& part : {json_number({}), json_number(std::numeric_limits<double>::infinity()),
                           json_number(std::nan("")), json_kPa({}), json_deg({}), json_text("")})
    CHECK(part.is_null());
}

TEST_CASE("units of the field") {
  CHECK(json_kPa(56.5e3) == 56.5);
  CHECK(json_kPa(500.12 * 1e3).dump() == "500.12");
  CHECK(json_deg(std::numbers::pi).get<double>() == Approx(180));
  CHECK(json_text("a") == "a");
}

TEST_CASE("a material names its law, and a document ends its line") {
  const Json material = json_material(triax::lab::find_material("inl2/S28-general"));
  CHECK(material["name"] == "inl2/S28-general");
  CHECK(material["law"] == "inl2");
  for (const char* key : {"based_on", "source", "range"}) CHECK(material[key].is_string());
  const std::string text = json_document({{"broken", "\xff"}});
  CHECK(text.back() == '\n');
  CHECK(Json::parse(text)["broken"].is_string());
}
