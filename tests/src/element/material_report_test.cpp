// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/element/material_report.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace triax;
using nlohmann::json;

TEST_CASE("every shipped set is listed, and every parameter of it told") {
  const auto& sets = lab::shipped_materials();
  const std::string list = src::materials_text(sets);
  const json laws = json::parse(src::materials_json(sets));
  CHECK(laws.size() == sim::laws().size());
  for (const auto& set : sets) {
    INFO(set.name);
    CHECK(list.find("  " + set.name + "\n") != std::string::npos);
    CHECK(list.find(set.source) != std::string::npos);
    const std::string text = src::material_text(set);
    const json one = json::parse(src::material_json(set));
    CHECK(one["law"]["name"] == set.law->name);
    REQUIRE(one["p_eff_range_kPa"].is_null() != set.p_eff_range_kPa.has_value());
    if (set.p_eff_range_kPa) {
      CHECK(one["p_eff_range_kPa"][0] == set.p_eff_range_kPa->low);
      CHECK(one["p_eff_range_kPa"][1] == set.p_eff_range_kPa->high);
    }
    REQUIRE(one["void_ratio_range"].is_null() != set.void_ratio_range.has_value());
    if (set.void_ratio_range) {
      CHECK(one["void_ratio_range"] ==
            std::vector<double>{set.void_ratio_range->low, set.void_ratio_range->high});
    }
    REQUIRE(one["parameters"].size() == set.law->parameters.size());
    for (std::size_t i = 0; i < set.law->parameters.size(); ++i) {
      const auto& parameter = set.law->parameters[i];
      CHECK(text.find(parameter.key) != std::string::npos);
      CHECK(one["parameters"][i]["key"] == parameter.key);
      if (const auto given = set.parameters.numbers.find(parameter.key);
          given != set.parameters.numbers.end())
        CHECK(one["parameters"][i]["value"] == given->second);
    }
  }
}

TEST_CASE("a value that the set leaves out is the usual one, and none is null") {
  sim::LawDescription law{
      .name = "l", .title = "t", .source = "s", .refuses = "", .parameters = {}, .make = {}};
  law.parameters = {{"a", "", "", "with a usual value", {}, sim::ParameterKind::number, 2.5},
                    {"b", "", "", "a file", {}, sim::ParameterKind::text, {}},
                    {"c", "", "", "some", {}, sim::ParameterKind::numbers, {}}};
  lab::MaterialSet set;
  set.name = "l/x";
  set.law = &law;
  set.parameters.lists["c"] = {1, 2, 3};
  const json d = json::parse(src::material_json(set));
  CHECK(d["parameters"][0]["value"] == 2.5);
  CHECK(d["parameters"][1]["value"].is_null());
  CHECK(d["parameters"][2]["value"] == std::vector<double>{1, 2, 3});
  CHECK(d["range"].is_null());
  // A range is told of numbers only.
  CHECK(d["parameters"][0]["range"] == "a finite number");
  CHECK(d["parameters"][1]["range"].is_null());
  CHECK(d["parameters"][2]["range"].is_null());
  for (const std::string& told : {src::material_text(set), src::law_text(law)}) {
    const auto at = told.find("a finite number");
    REQUIRE(at != std::string::npos);
    CHECK(told.find("a finite number", at + 1) == std::string::npos);
  }
  CHECK(src::material_text(set).find("3 numbers") != std::string::npos);
  const json bare = json::parse(src::law_json(law));
  CHECK_FALSE(bare["parameters"][0].contains("value"));
  CHECK(src::law_text(law).find("with a usual value") != std::string::npos);
}
