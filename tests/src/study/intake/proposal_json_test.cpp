// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/proposal_json.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "src/study/intake/import_questions.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using study::Json;

namespace {

const lab::DialectMemory kNoMemory{""};

std::string json_table(const std::string& headings) {
  std::string text = "Height (mm),76\n\n" + headings + "\n";
  for (int i = 0; i < 40; ++i) {
    const double q = 3.0 * i, u = 200 + 1.5 * i;
    text += std::to_string(0.1 * i) + ',' + std::to_string(q) + ',' + std::to_string(u) + ",400\n";
  }
  return text;
}

Json json_of(const std::string& text, const lab::DialectMemory& memory = kNoMemory) {
  const auto source = lab::open_memory("t.csv", text);
  return study::proposal_json(*source, memory);
}

}  // namespace

TEST_CASE("proposal_json: columns with their rows as the file has them", "[intake]") {
  const Json all = json_of(
      json_table("Axial strain (%),Deviator stress (kPa),Pore pressure (kPa),Cell pressure (kPa)"));
  REQUIRE(all["tables"].size() == 1);
  const Json& one = all["tables"][0];
  REQUIRE(one["columns"].size() == 4);
  CHECK(one["columns"][1]["quantity"] == "deviator_stress");
  CHECK(one["columns"][1]["unit"] == "kPa");
  CHECK(one["columns"][1]["heading"] == "Deviator stress (kPa)");
  CHECK(one["columns"][1]["evidence"].get<std::string>().find("name") != std::string::npos);
  REQUIRE(one["rows"].size() == 10);
  CHECK(one["rows"][2] == Json::array({"0.200000", "6.000000", "203.000000", "400"}));
  CHECK(one["stated"]["specimen.height_mm"] == 76);
  CHECK(all["separator"] == "comma");
  CHECK(all["key"].get<std::string>().size() == 32);
  CHECK(all["values"].size() == 6);
}

TEST_CASE("proposal_json: every quantity that is offered is one of a dialect", "[intake]") {
  const Json all = json_of(
      json_table("Axial strain (%),Deviator stress (kPa),Pore pressure (kPa),Cell pressure (kPa)"));
  CHECK(all["quantities"].size() > 30);
  for (const Json& one : all["quantities"]) {
    auto units = one["units"];
    if (units.empty()) units.push_back("");
    for (const Json& unit : units) {
      const auto name = unit.get<std::string>();
      const std::string toml = "name = \"d\"\n[columns]\n" + one["name"].get<std::string>() +
                               " = { column = 1" +
                               (name.empty() ? "" : ", unit = \"" + name + "\"") + " }\n";
      INFO(toml);
      CHECK_NOTHROW(lab::parse_dialect(toml, "d"));
    }
  }
}

TEST_CASE("proposal_json: questions are those of the terminal", "[intake]") {
  const std::string open =
      "Time,Strain (%),q (kPa),u (kPa)\n0,0,0,200\n1,0.5,50,220\n2,1,80,240\n"
      "3,2,100,255\n4,3,110,262\n5,4,112,265\n";
  const Json one = json_of(open)["tables"][0];
  const auto source = lab::open_memory("t.csv", open);
  const lab::Proposal proposal = lab::propose(*source).front();
  const auto asked = study::open_questions(proposal, study::usual_choices(proposal, {}));
  REQUIRE(asked.size() == 2);
  REQUIRE(one["questions"].size() == asked.size());
  for (std::size_t i = 0; i < asked.size(); ++i) {
    CHECK(one["questions"][i]["text"] == asked[i].text);
    CHECK(one["questions"][i]["explanation"] == asked[i].explanation);
    CHECK(one["questions"][i]["column"] == asked[i].position);
  }
  CHECK(one["questions"][0]["about"] == "unit");
  CHECK(one["questions"][1]["about"] == "value");
  CHECK(one["columns"][0]["unit"] == "");
}

TEST_CASE("proposal_json: the kind of a test in total stresses has its answers", "[intake]") {
  std::string text = "Axial strain (%),Deviator stress (kPa)\n";
  for (int i = 0; i < 40; ++i) text += fmt::format("{},{}\n", 0.1 * i, 3.0 * i);
  const Json questions = json_of(text)["tables"][0]["questions"];
  REQUIRE(questions.size() == 1);
  CHECK(questions[0]["about"] == "programme");
  REQUIRE(questions[0]["answers"].size() == 3);
  CHECK(questions[0]["answers"][0]["value"] == "UU");
}

TEST_CASE("proposal_json: a gauge has its factor", "[intake]") {
  std::string text =
      "Ring factor (N/div),2.5\n\nTime (s),Dial gauge (mm),Proving ring (div),"
      "Cell pressure (kPa),Pore pressure (kPa)\n";
  for (int i = 0; i < 40; ++i)
    text += fmt::format("{},{:.2f},{},400,{}\n", 10 * i, 0.1 * i, 4 * i, 200 + 1.5 * i);
  const Json columns = json_of(text)["tables"][0]["columns"];
  CHECK(columns[1]["quantity"] == "axial_displacement");
  CHECK(columns[1]["factor"] == 1);
  CHECK(columns[2]["quantity"] == "axial_force");
  CHECK(columns[2]["unit"] == "N");
  CHECK(columns[2]["factor"] == 2.5);
  const Json open = json_of(text.substr(text.find('\n')))["tables"][0];
  CHECK(open["columns"][2]["factor"] == 1);
  REQUIRE_FALSE(open["questions"].empty());
  CHECK(open["questions"][0]["about"] == "factor");
  CHECK(open["questions"][0]["column"] == 3);
}

TEST_CASE("proposal_json: a column that names tests is offered as such", "[intake]") {
  std::string text =
      "Specimen,Axial strain (%),Deviator stress (kPa),Pore pressure (kPa),"
      "Cell pressure (kPa)\n";
  for (int i = 0; i < 60; ++i)
    text += fmt::format("{},{},{},{},400\n", i < 30 ? "A" : "B", 0.1 * (i % 30), 3.0 * (i % 30),
                        200 + 1.5 * (i % 30));
  const Json all = json_of(text);
  CHECK(all["tables"][0]["columns"][0]["quantity"] == "test");
  CHECK(std::ranges::any_of(all["quantities"],
                            [](const Json& one) { return one["name"] == "test"; }));
}

TEST_CASE("proposal_json: columns without headings are one question", "[intake]") {
  const Json all = json_of("1,2,3\n2,3,4\n3,4,5\n4,5,6\n");
  const Json& one = all["tables"][0];
  REQUIRE(one["questions"].size() == 1);
  CHECK(one["questions"][0]["about"] == "quantity");
  CHECK(one["questions"][0]["column"] == 0);
  CHECK(one["columns"][0]["quantity"].is_null());
  CHECK(all["key"].is_null());
}

TEST_CASE("proposal_json: a missing cell pressure is asked for", "[intake]") {
  std::string text = "Axial strain (%),Deviator stress (kPa),Pore pressure (kPa)\n";
  for (int i = 0; i < 40; ++i)
    text += std::to_string(0.1 * i) + ',' + std::to_string(3.0 * i) + ',' +
            std::to_string(200 + 1.5 * i) + '\n';
  const Json one = json_of(text)["tables"][0];
  CHECK(one["asked"] == Json::array({"test.cell_pressure_kPa"}));
}

TEST_CASE("proposal_json: columns are those of a remembered dialect", "[intake]") {
  const triax::testing::TemporaryFolder folder;
  const lab::DialectMemory memory(folder.file("d"));
  const std::string text =
      json_table("Axial strain (%),Deviator stress (kPa),Pore pressure (kPa),X");
  memory.store(json_of(text)["key"].get<std::string>(),
               "name = \"mine\"\n[columns]\naxial_strain = { column = 1, unit = \"mm/mm\" }\n"
               "pore_pressure = { column = 2, unit = \"MPa\", factor = 3, sign = -1 }\n");
  const Json all = json_of(text, memory);
  CHECK(all["remembered"].is_string());
  const Json& columns = all["tables"][0]["columns"];
  CHECK(columns[0]["unit"] == "mm/mm");
  CHECK(columns[1]["quantity"] == "pore_pressure");
  CHECK(columns[1]["sign"] == -1);
  CHECK(columns[1]["factor"] == 3);
  CHECK(columns[1]["evidence"] == "remembered for these headings");
  CHECK(columns[2]["quantity"].is_null());
}

TEST_CASE("proposal_json: huge and hostile files stay small", "[intake]") {
  std::string wide, row;
  for (int i = 0; i < 3000; ++i) {
    wide += "<b>" + std::string(300, 'h') + std::to_string(i) + "\xc3\xa4,";
    row += std::to_string(i) + ",";
  }
  const Json all = json_of(wide + "\n" + row + "\n" + row + "\n" + row + "\n" + row + "\n");
  CHECK(all["tables"][0]["columns"].size() == 256);
  CHECK(all.dump().size() < 300'000);
  CHECK_THROWS_AS(json_of("only text\nand more\n"), lab::BadInput);
  CHECK_THROWS_AS(json_of(""), lab::BadInput);
  CHECK_THROWS_AS(json_of(std::string(1000, '\0')), lab::BadInput);
  CHECK_NOTHROW(json_of("a\xff,b\xfe\n1,2\n2,3\n3,4\n4,5\n").dump());
}
