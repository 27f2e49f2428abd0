// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/programme_form.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "src/page/request/request.hpp"

using namespace triax;
using namespace triax::src;

TEST_CASE("every sample has a form, and its values lead to the programme itself") {
  const auto forms = programme_forms();
  CHECK(forms.size() >= 20);
  for (const auto& form : forms) {
    INFO(form["name"]);
    CHECK(form["fields"].size() >= 3);
    std::vector<lab::TomlEdit> edits;
    for (const auto& field : form["fields"]) {
      INFO(field["key"]);
      const auto value = field["value"];
      if (field["kind"] == "number") {
        CHECK(field["min"].get<double>() <= value.get<double>());
        CHECK(value.get<double>() <= field["max"].get<double>());
        CHECK(field["step"].get<double>() > 0);
      }
      const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
      if (field["key"] == "test.seed") continue;
      edits.push_back({field["key"], text});
      for (const auto& also : field["also"]) edits.push_back({also, text});
    }
    const auto plain = programme_of(form["name"], {});
    const auto edited = programme_of(form["name"], edits);
    CHECK(edited.void_ratio == plain.void_ratio);
    REQUIRE(edited.stages.size() == plain.stages.size());
    for (std::size_t i = 0; i < plain.stages.size(); ++i) {
      CHECK(edited.stages[i].axial_rate_m_per_s == plain.stages[i].axial_rate_m_per_s);
      CHECK(edited.stages[i].cell.target_pa == plain.stages[i].cell.target_pa);
    }
  }
}

TEST_CASE("a cell pressure of consolidation moves the end that waits for it") {
  const auto forms = programme_forms();
  const auto form =
      std::ranges::find_if(forms, [](const auto& f) { return f["name"] == "csu_26"; });
  REQUIRE(form != forms.end());
  const auto& fields = (*form)["fields"];
  const auto field = std::ranges::find_if(fields, [](const auto& f) { return !f["also"].empty(); });
  REQUIRE(field != fields.end());
  CHECK((*field)["key"] == "stages.3.cell_target_kPa");
  CHECK((*field)["also"] == study::Json::array({"stages.3.end.1.above"}));
  const auto programme = programme_of(
      "csu_26", {{"stages.3.cell_target_kPa", "700"}, {"stages.3.end.1.above", "700"}});
  CHECK(programme.stages[2].cell.target_pa == 700e3);
  CHECK(programme.stages[2].end.front().above == 700e3);
  CHECK(programme.name == "CSU 26 [cell_target_kPa 700, above 700]");
}

TEST_CASE("programme_of: a path is no name of a sample") {
  CHECK_THROWS_AS(programme_of("/etc/passwd", {}), Refused);
  CHECK_THROWS_AS(programme_of("../csu_26", {}), Refused);
  CHECK_THROWS_AS(programme_of("no = \n toml", {}), lab::BadInput);
}

TEST_CASE("programme_of: every key that names a file is refused") {
  const std::string text(*sample_programme("csu_26"));
  CHECK(programme_of(text, {}).name == "CSU 26");
  for (const auto& [table, key] : lab::kProgrammeFileKeys) {
    const std::string name = std::string(table) + '.' + std::string(key);
    const auto refusal = Catch::Contains(
        name + ": a programme in the web interface cannot use files of this computer");
    CHECK_THROWS_WITH(programme_of("csu_26", {{name, "/etc/passwd"}}), refusal);
    std::string with_file = text;
    with_file.replace(with_file.find("[specimen]"), 10,
                      "[specimen]\n" + std::string(key) + " = \"x\"");
    CHECK_THROWS_WITH(programme_of(with_file, {}), refusal);
  }
}
