// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/import_questions.hpp"
#include "src/study/intake/column_questions.hpp"
#include "src/study/intake/import_answers.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "lab/records/dialect.hpp"
#include "src/study/intake/column_evidence.hpp"

using namespace triax;
using namespace triax::study;

namespace {

constexpr const char* kTwoQuestions =
    "Time,Strain (%),q (kPa),u (kPa)\n0,0,0,200\n1,0.5,50,220\n2,1,80,240\n3,2,100,255\n"
    "4,3,110,262\n5,4,112,265\n";

lab::Proposal propose_table(const std::string& bytes) {
  const auto source = lab::open_memory("x.csv", bytes);
  return lab::propose(*source).front();
}

}  // namespace

TEST_CASE("ImportQuestion: the proposed answer is among those that are offered") {
  const auto proposal = propose_table(kTwoQuestions);
  const ImportChoices choices = usual_choices(proposal, {.name = "x"});
  for (std::size_t column = 1; column <= 4; ++column) {
    std::vector<ImportQuestion> all{quantity_question(proposal, choices, column)};
    if (const auto unit = unit_question(proposal, choices, column)) all.push_back(*unit);
    if (const auto sign = sign_question(choices, column)) all.push_back(*sign);
    CHECK(all.size() == (column == 1 ? 2 : 3));
    for (const ImportQuestion& one : all) {
      INFO(one.text);
      CHECK(std::ranges::count(one.answers, one.usual, &ImportAnswer::value) == 1);
      CHECK_FALSE(one.explanation.empty());
    }
  }
}

TEST_CASE("ImportQuestion: a dimension offers the usual slenderness of the other") {
  const auto proposal = propose_table(
      "Time (s),Displacement (mm),Load (kN),Cell pressure (kPa),Pore pressure (kPa)\n"
      "0,0,0,300,200\n10,0.5,0.1,300,220\n20,1,0.15,300,240\n30,1.5,0.18,300,250\n");
  ImportChoices choices = usual_choices(proposal, {.name = "x"});
  REQUIRE(open_questions(proposal, choices).size() == 2);
  CHECK(open_questions(proposal, choices)[0].usual == "76");
  REQUIRE(give_answer(choices, open_questions(proposal, choices)[0], "140").empty());
  REQUIRE(open_questions(proposal, choices).size() == 1);
  CHECK(open_questions(proposal, choices)[0].usual == "70");
}

TEST_CASE("column_evidence: name and relations of a column") {
  const auto proposal = propose_table(
      "Strain (%),q (kPa),p' (kPa),u (kPa)\n0,0,150,200\n0.5,30.9,149.5,231.4\n"
      "1,42.25,140.25,252\n2,48.2,136.9,261.3\n4,52,137.9,264.1\n");
  CHECK(column_evidence(proposal, 0) == "name");
  CHECK(column_evidence(proposal, 1).find("constant (+") != std::string::npos);
}

TEST_CASE("ImportQuestion: answers that are not valid change nothing") {
  const auto proposal = propose_table(kTwoQuestions);
  ImportChoices choices = usual_choices(proposal, {.name = "x"});
  const std::string before = dialect_text(choices);
  const auto open = open_questions(proposal, choices);
  REQUIRE(open.size() == 2);
  for (const char* wrong : {"", "kPa", "7", "mni", "\x01\xff", "min min"})
    CHECK_FALSE(give_answer(choices, open[0], wrong).empty());
  for (const char* wrong : {"", "x", "nan", "inf", "1e999", "-1e9", "300 kPa"})
    CHECK_FALSE(give_answer(choices, open[1], wrong).empty());
  const auto quantity = quantity_question(proposal, choices, 3);
  CHECK(give_answer(choices, quantity, "pore presure").find("did you mean") != std::string::npos);
  CHECK(give_answer(choices, quantity, "Load").find("can be: ") != std::string::npos);
  CHECK(dialect_text(choices) == before);
}

TEST_CASE("ImportQuestion: a quantity moves to the column that is corrected") {
  const auto proposal = propose_table(kTwoQuestions);
  ImportChoices choices = usual_choices(proposal, {.name = "x"});
  REQUIRE(give_answer(choices, quantity_question(proposal, choices, 3), "pore_pressure").empty());
  CHECK(choices.at(3)->quantity == "pore_pressure");
  CHECK(choices.at(3)->unit == "kPa");
  CHECK(choices.at(4)->quantity.empty());
  CHECK(choices.at(5) == nullptr);
  CHECK(lab::parse_dialect(dialect_text(choices), "x").columns.size() == 3);
}

TEST_CASE("ImportQuestion: raw channels need values beside reduced columns") {
  const auto proposal = propose_table(
      "Effective consolidation stress (kPa),100,,,,\n"
      "Time (s),Displacement (mm),Load (N),Axial strain (%),Deviator stress (kPa),"
      "Pore pressure (kPa)\n"
      "0,0,0,0,0,300\n10,0.5,100,0.5,87.7,320\n20,1,150,1,130.9,340\n30,1.5,180,1.5,156.3,350\n");
  ImportChoices choices = usual_choices(proposal, {.name = "x"});
  for (const char* usual : {"38", "400", "76"}) {
    const auto open = open_questions(proposal, choices);
    REQUIRE_FALSE(open.empty());
    INFO(open.front().text);
    CHECK(open.front().usual == usual);
    REQUIRE(give_answer(choices, open.front(), usual).empty());
  }
  CHECK(open_questions(proposal, choices).empty());
}

TEST_CASE("ImportQuestion: a column can name the tests") {
  const auto proposal = propose_table(
      "X,Axial strain (%),q (kPa),p' (kPa)\nA,0,0,100\nA,0.5,50,96.7\nA,1,80,86.7\nA,2,100,78.3\n"
      "B,0,0,100\nB,0.5,50,96.7\nB,1,80,86.7\nB,2,100,78.3\n");
  ImportChoices choices = usual_choices(proposal, {.name = "x"});
  REQUIRE(give_answer(choices, quantity_question(proposal, choices, 1), "not used").empty());
  CHECK(dialect_text(choices).find("test = ") == std::string::npos);
  const ImportQuestion quantity = quantity_question(proposal, choices, 1);
  CHECK(std::ranges::count(quantity.answers, "test", &ImportAnswer::value) == 1);
  REQUIRE(give_answer(choices, quantity, "test").empty());
  CHECK(dialect_text(choices).find("test = { column = 1 }") != std::string::npos);
  CHECK(lab::parse_dialect(dialect_text(choices), "x").columns.size() == 4);
}

TEST_CASE("ImportQuestion: readings of a ring become a force by their factor") {
  const auto proposal = propose_table(
      "Time (s),Dial gauge (mm),Proving ring (div),Cell pressure (kPa),Pore pressure (kPa)\n"
      "0,0,0,300,200\n10,0.5,40,300,220\n20,1,60,300,240\n30,1.5,72,300,250\n");
  ImportChoices choices = usual_choices(proposal, {.name = "x"});
  const ImportQuestion factor = open_questions(proposal, choices).front();
  CHECK(factor.position == 3);
  CHECK(factor.unit == "N per reading");
  for (const char* wrong : {"", "0", "N", "nan", "1e999"})
    CHECK_FALSE(give_answer(choices, factor, wrong).empty());
  CHECK(choices.at(3)->quantity == "force_reading");
  REQUIRE(give_answer(choices, factor, "-2.5").empty());
  CHECK(choices.at(3)->quantity == "axial_force");
  CHECK(choices.at(3)->factor == 2.5);
  CHECK(choices.at(3)->sign == -1);
  for (const ImportQuestion& one : open_questions(proposal, choices)) CHECK(one.position == 0);
  REQUIRE(give_answer(choices, quantity_question(proposal, choices, 3), "pore_pressure").empty());
  CHECK(choices.at(3)->factor == 1);
}
