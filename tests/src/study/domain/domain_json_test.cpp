// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_json.hpp"

#include <catch2/catch.hpp>

using namespace triax::study;

TEST_CASE("a mark that is not known is null, and its angle is where only that is not") {
  CHECK(mark_json(std::nullopt).is_null());
  const auto mark = mark_json(DomainMark{10, 0.5, std::nullopt});
  CHECK(mark["q_kPa"] == 10.0);
  CHECK(mark["eta"] == 0.5);
  CHECK(mark["alpha_deg"].is_null());
}

TEST_CASE("a boundary has all five criteria, each under its own name") {
  ReportedBoundary boundary;
  double q = 0;
  for (const std::string& key : boundary_keys()) boundary.set_mark(key, DomainMark{++q, 0, {}});
  const auto json = boundary_json(boundary);
  CHECK(json.size() == 5);
  CHECK(json["first_unstable"]["q_kPa"] == 1.0);
  CHECK(json["isotropic_unloading"]["q_kPa"] == 2.0);
  CHECK(json["determinant"]["q_kPa"] == 3.0);
  CHECK(json["localisation"]["q_kPa"] == 4.0);
  CHECK(json["limit"]["q_kPa"] == 5.0);
}

TEST_CASE("bytes that are no UTF-8 do not break a document; empty words are null") {
  DomainSettings::Material material{.name = "a\xff", .law = "b"};
  const std::string text = dumped(material_json(material));
  CHECK(nlohmann::json::parse(text)["name"] == "a\xEF\xBF\xBD");
  CHECK(nlohmann::json::parse(text)["source"].is_null());
}
