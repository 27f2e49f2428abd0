// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/import_choices.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/records/dialect.hpp"
#include "lab/rig/recorded.hpp"
#include "src/study/intake/import_answers.hpp"
#include "src/study/intake/import_questions.hpp"

using namespace triax;
using namespace triax::study;

namespace {

constexpr const char* kOpenTime =
    "Time,Strain (%),q (kPa),u (kPa)\n0,0,0,200\n1,0.5,50,220\n2,1,80,240\n3,2,100,255\n"
    "4,3,110,262\n5,4,112,265\n";
constexpr const char* kNoHeadings =
    "0,0,100,200\n0.5,50,100,220\n1,80,100,240\n2,100,100,255\n3,110,100,262\n4,112,100,265\n";

lab::Proposal proposal_of(const std::string& bytes) {
  const auto source = lab::open_memory("x.csv", bytes);
  return lab::propose(*source).front();
}

std::unique_ptr<lab::RecordedRig> read(const std::string& bytes, const ImportChoices& choices) {
  lab::RecordOptions options;
  options.dialect_text = dialect_text(choices);
  return lab::open_record(lab::open_memory("x.csv", bytes), options);
}

/// Answers all open questions, the usual answer unless `answers` has one for the text.
void answer_all(const lab::Proposal& proposal, ImportChoices& choices,
                const std::vector<std::pair<std::string, std::string>>& answers) {
  for (int left = 30; left > 0; --left) {
    const auto open = open_questions(proposal, choices);
    if (open.empty()) return;
    std::string answer = open.front().usual;
    for (const auto& [part, text] : answers)
      if (open.front().text.find(part) != std::string::npos) answer = text;
    INFO(open.front().text << ": " << answer);
    REQUIRE(give_answer(choices, open.front(), answer).empty());
  }
  FAIL("questions without end");
}

std::vector<std::string> texts(const std::vector<ImportQuestion>& questions) {
  std::vector<std::string> out;
  for (const ImportQuestion& one : questions) out.push_back(one.text);
  return out;
}

}  // namespace

TEST_CASE("ImportChoices: answers become a dialect that reads the record") {
  const auto proposal = proposal_of(kOpenTime);
  ImportChoices choices = usual_choices(proposal, {.name = "x"});
  CHECK(texts(open_questions(proposal, choices)) ==
        std::vector<std::string>{"unit of column 1 'Time', time", "held cell pressure"});
  answer_all(proposal, choices, {{"unit", "min"}, {"cell", "300"}});
  const lab::Dialect dialect = lab::parse_dialect(dialect_text(choices), "x.toml");
  REQUIRE(dialect.columns.size() == 4);
  CHECK(dialect.columns[0].position == 1);
  CHECK(dialect.columns[0].unit == "min");
  REQUIRE(dialect.constants.size() == 1);
  CHECK(dialect.constants[0].si == Approx(300e3));
  const auto record = read(kOpenTime, choices);
  lab::Reading reading;
  REQUIRE(record->next(reading));
  REQUIRE(record->next(reading));
  CHECK(reading.time_s == Approx(60));
  CHECK(reading.si[lab::index(lab::Quantity::cell_pressure)] == Approx(300e3));
  CHECK(reading.si[lab::index(lab::Quantity::deviator_stress)] == Approx(50e3));
}

TEST_CASE("ImportChoices: columns without headings are named, then their units") {
  const auto proposal = proposal_of(kNoHeadings);
  ImportChoices choices = usual_choices(proposal, {.name = "x"});
  const auto first = open_questions(proposal, choices);
  REQUIRE(first.size() == 4);
  CHECK(first[0].about == ImportQuestion::About::quantity);
  CHECK(first[0].usual == "not used");
  answer_all(proposal, choices,
             {{"quantity of column 1", "axial strain"},
              {"quantity of column 2", "deviator stress"},
              {"quantity of column 3", "mean_effective_stress"},
              {"quantity of column 4", "Pore pressure"},
              {"unit of column 1", "%"}});
  const auto record = read(kNoHeadings, choices);
  lab::Reading reading;
  REQUIRE(record->next(reading));
  REQUIRE(record->next(reading));
  CHECK(reading.si[lab::index(lab::Quantity::axial_strain)] == Approx(0.005));
  CHECK(reading.si[lab::index(lab::Quantity::deviator_stress)] == Approx(50e3));
}

TEST_CASE("ImportChoices: dimensions are values of the specimen in the dialect") {
  const std::string table =
      "Time (s),Displacement (mm),Load (kN),Cell pressure (kPa),Pore pressure (kPa)\n"
      "0,0,0,300,200\n10,0.5,0.1,300,220\n20,1,0.15,300,240\n30,1.5,0.18,300,250\n";
  const auto proposal = proposal_of(table);
  ImportChoices choices = usual_choices(proposal, {.name = "x"});
  CHECK(texts(open_questions(proposal, choices)) ==
        std::vector<std::string>{"height of the specimen", "diameter of the specimen"});
  answer_all(proposal, choices, {{"height", "140"}});
  CHECK(read(table, choices)->header().specimen.height_m == Approx(0.14));
  CHECK(read(table, choices)->header().specimen.diameter_m == Approx(0.07));
}

TEST_CASE("ImportChoices: one answer gives p', q or s', t to both columns") {
  const std::string table =
      "Strain (%),q (kPa),p' (kPa),u (kPa)\n0,0,150,200\n0.5,30.9,149.5,231.4\n"
      "1,42.25,140.25,252\n2,48.2,136.9,261.3\n4,52,137.9,264.1\n";
  const auto proposal = proposal_of(table);
  ImportChoices choices = usual_choices(proposal, {.name = "x"});
  const auto open = open_questions(proposal, choices);
  REQUIRE(texts(open) == std::vector<std::string>{"definition of the stresses"});
  CHECK(open.front().usual == "s t");
  ImportChoices other = choices;
  REQUIRE(give_answer(choices, open.front(), "s t").empty());
  REQUIRE(give_answer(other, open.front(), "p q").empty());
  CHECK(open_questions(proposal, choices).empty());
  CHECK(open_questions(proposal, other).empty());
  lab::Reading reading;
  const auto plane = read(table, choices);
  while (plane->next(reading)) continue;
  CHECK(reading.si[lab::index(lab::Quantity::deviator_stress)] == Approx(104e3));
  const auto space = read(table, other);
  while (space->next(reading)) continue;
  CHECK(reading.si[lab::index(lab::Quantity::deviator_stress)] == Approx(52e3));
}

TEST_CASE("ImportChoices: day and month are asked once and reach the dialect") {
  const std::string table =
      "Clock,Strain (%),q (kPa),p' (kPa)\n03/04/2026 10:00,0,0,100\n03/04/2026 10:01,0.5,50,96.7\n"
      "03/04/2026 10:02,1,80,86.7\n03/04/2026 10:03,2,100,78.3\n";
  const auto proposal = proposal_of(table);
  ImportChoices choices = usual_choices(proposal, {.name = "x"});
  answer_all(proposal, choices, {{"order", "month first"}});
  CHECK(dialect_text(choices).find("date_order = \"month first\"") != std::string::npos);
  CHECK(lab::parse_dialect(dialect_text(choices), "x").columns[0].date_order ==
        lab::DateOrder::month_first);
}

TEST_CASE("ImportChoices: excess pore pressure and a consolidation stress") {
  const std::string table =
      "Strain (%),q (kPa),Excess pore pressure (kPa)\n0,0,0\n0.5,50,20\n1,80,40\n2,100,55\n";
  const auto proposal = proposal_of(table);
  ImportChoices choices = usual_choices(proposal, {.name = "x"});
  answer_all(proposal, choices, {{"consolidation", "100"}});
  const auto record = read(table, choices);
  lab::Reading reading;
  while (record->next(reading)) continue;
  CHECK(reading.si[lab::index(lab::Quantity::pore_pressure)] == Approx(55e3));
  CHECK(reading.si[lab::index(lab::Quantity::cell_pressure)] == Approx(100e3));
}

TEST_CASE("ImportChoices: hostile headings and equal quantities are valid TOML") {
  ImportChoices choices;
  choices.name = "a\"b\n]";
  choices.sheet = "=1\"";
  choices.columns = {{.position = 1, .heading = "x\n[columns]\x1b[2J\xff", .quantity = "time"},
                     {.position = 2, .heading = "", .quantity = "time", .unit = "s"},
                     {.position = 3, .quantity = "clock"},
                     {.position = 4, .quantity = "temperature", .unit = "degC"},
                     {.position = 5, .heading = "\n", .quantity = ""},
                     {.position = 6, .quantity = "axial_strain", .unit = "%", .sign = -1}};
  choices.set_constant("axial_strain", 1, "%");
  choices.set_constant("cell_pressure", 300, "kPa");
  const std::string text = dialect_text(choices);
  const lab::Dialect dialect = lab::parse_dialect(text, "x.toml");
  CHECK(dialect.columns.size() == 2);
  CHECK(dialect.constants.size() == 1);
  CHECK(dialect.name == "a\"b\n]");
  CHECK(dialect.columns[1].sign == -1);
  CHECK(text.find('\x1b') == std::string::npos);
}
