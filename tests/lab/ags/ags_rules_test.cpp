// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/ags_rules.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

namespace {

std::string row(const char* kind, const std::string& cells) {
  std::string out = std::string("\"") + kind + "\",\"";
  for (const char c : cells) {
    if (c == '|')
      out += "\",\"";
    else
      out += c;
  }
  return out + "\"\r\n";
}

/// Cells apart by |, rows of data by line ends.
std::string table(const std::string& group, const std::string& headings, const std::string& units,
                  const std::string& types, const std::string& data) {
  std::string out = row("GROUP", group);
  out += row("HEADING", headings);
  out += row("UNIT", units);
  out += row("TYPE", types);
  std::istringstream lines(data);
  for (std::string line; std::getline(lines, line);) out += row("DATA", line);
  return out + "\r\n";
}

const std::string kProj = table("PROJ", "PROJ_ID", "", "ID", "1");
const std::string kTran =
    table("TRAN", "TRAN_ISNO|TRAN_DATE|TRAN_PROD|TRAN_STAT|TRAN_AGS|TRAN_RECV", "|yyyy-mm-dd||||",
          "X|DT|X|X|X|X", "1|2026-11-25|lab|Final|4.1.1|us");
const std::string kUnit =
    table("UNIT", "UNIT_UNIT|UNIT_DESC", "|", "X|X", "m|metre\nyyyy-mm-dd|date");
const std::string kType =
    table("TYPE", "TYPE_TYPE|TYPE_DESC", "|", "X|X",
          "X|text\nID|name\nDT|date\nPA|code\n2DP|number\nPT|type\nPU|unit\n3DP|number");
const std::string kAbbr = table("ABBR", "ABBR_HDNG|ABBR_CODE|ABBR_DESC", "||", "X|X|X",
                                "SAMP_TYPE|U|undisturbed\nDICT_TYPE|HEADING|h\nDICT_STAT|OTHER|o");
const std::string kLoca = table("LOCA", "LOCA_ID", "", "ID", "BH1");
const std::string kSampNames = "LOCA_ID|SAMP_TOP|SAMP_REF|SAMP_TYPE|SAMP_ID";
const std::string kSamp = table("SAMP", kSampNames, "|m|||", "ID|2DP|X|PA|ID", "BH1|1.50|1|U|");
const std::string kGood = kProj + kTran + kUnit + kType + kAbbr + kLoca;

/// The rules that a file breaks, each once.
std::string broken(const std::string& text) {
  std::string out;
  for (const auto& finding : check_ags(*open_memory("x.ags", text)).findings) {
    INFO(in_words(finding));
    if ((' ' + out + ' ').find(' ' + finding.rule + ' ') == std::string::npos)
      out += (out.empty() ? "" : " ") + finding.rule;
  }
  return out;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("a file that keeps to the rules has no finding") { CHECK(broken(kGood + kSamp) == ""); }

TEST_CASE("each rule is told when it alone is broken") {
  const auto good = kGood + kSamp;
  CHECK(broken(with(good, "lab",
                    "l\xE4"
                    "b")) == "1");
  CHECK(broken(with(good, "\"DATA\",\"BH1\",\"1.50\",\"1\",\"U\",\"\"\r\n", "")) == "2");
  CHECK(broken(with(good, "\"ID\"\r\n", "\"ID\"\n")) == "2a");
  CHECK(broken(with(good, "\"UNIT\",\"\"\r\n\"TYPE\",\"ID\"\r\n\"DATA\",\"1\"",
                    "\"TYPE\",\"ID\"\r\n\"UNIT\",\"\"\r\n\"DATA\",\"1\"")) == "2b");
  CHECK(broken(good + "\"NOTE\",\"x\"\r\n") == "3");
  CHECK(broken(with(good, "\"DATA\",\"BH1\"\r\n", "\"DATA\",\"BH1\",\"x\"\r\n")) == "2 4 10c");
  CHECK(broken(with(good, "\"DATA\",\"1\"\r\n", "DATA,1\r\n")) == "5");
  CHECK(broken(with(good, "\"lab\"", "\"l\"ab\"")) == "2 14 5");
  CHECK(broken(with(with(good, "SAMP_REF\",\"SAMP_TYPE", "SAMP_TYPE\",\"SAMP_REF"), "\"X\",\"PA\"",
                    "\"PA\",\"X\"")) == "7 16");
  CHECK(broken(with(good, "1.50", "1.5")) == "8");
  CHECK(broken(with(good, "\"HEADING\",\"LOCA_ID\"\r\n", "\"HEADING\",\"LOCA_IX\"\r\n")) ==
        "18 9 10a 10c");
  CHECK(
      broken(with(
          good, "\"BH1\",\"1.50\",\"1\",\"U\",\"\"\r\n",
          "\"BH1\",\"1.50\",\"1\",\"U\",\"\"\r\n\"DATA\",\"BH1\",\"1.50\",\"1\",\"U\",\"\"\r\n")) ==
      "10a");
  CHECK(broken(with(good, "\"lab\"", "\"\"")) == "10b");
  CHECK(broken(with(good, "\"BH1\",\"1.50\"", "\"BH2\",\"1.50\"")) == "10c");
  CHECK(broken(with(good, kProj, "")) == "13");
  CHECK(broken(with(good, kTran, "")) == "14");
  CHECK(broken(with(good, "\"DATA\",\"m\",\"metre\"\r\n", "")) == "15");
  CHECK(broken(with(good, "\"U\",\"\"\r\n", "\"B\",\"\"\r\n")) == "16");
  CHECK(broken(with(good, "\"DATA\",\"2DP\",\"number\"\r\n", "")) == "17");
  CHECK(broken(good + table("abcd", "ABCD_X", "", "X", "1")) == "19");
  CHECK(broken(good + table("ABCD", "ABCD_x", "", "X", "1")) == "19a");
  CHECK(broken(good + table("ABCD", "ABCDX", "", "X", "1")) == "19b");
  CHECK(broken(kGood + table("SAMP", kSampNames + "|FILE_FSET", "|m||||", "ID|2DP|X|PA|ID|X",
                             "BH1|1.50|1|U||F1")) == "20");
  CHECK(broken(kGood + table("SAMP", kSampNames + "|SAMP_LINK", "|m||||", "ID|2DP|X|PA|ID|RL",
                             "BH1|1.50|1|U||")) == "17 11a 11b");
}

TEST_CASE("headings that DICT declares are known, and held to what it says") {
  const auto dict =
      table("DICT", "DICT_TYPE|DICT_GRP|DICT_HDNG|DICT_STAT|DICT_DTYP|DICT_DESC|DICT_UNIT",
            "||||||", "PA|X|X|PA|PT|X|PU", "HEADING|LOCA|LOCA_ETAC|OTHER|3DP|eta|");
  const auto loca = table("LOCA", "LOCA_ID|LOCA_ETAC", "|", "ID|3DP", "BH1|0.590");
  const auto start = kProj + kTran + kUnit + kType + kAbbr;
  CHECK(broken(start + dict + loca) == "");
  CHECK(broken(start + loca) == "18 9");
}

TEST_CASE("groups without a dictionary are named, not judged") {
  const auto check =
      check_ags(*open_memory("x.ags", kGood + table("GEOL", "LOCA_ID", "", "ID", "BH1")));
  CHECK(check.findings.empty());
  CHECK(check.unknown_groups == std::vector<std::string>{"GEOL"});
}

TEST_CASE("bytes that are no text are bad input") {
  CHECK_THROWS_AS(check_ags(*open_memory("x.ags", std::string("\"GROUP\",\"\0\"", 11))), BadInput);
}

TEST_CASE("headings that 4.2 added are those of a file that says it is of 4.2") {
  const std::string with = "LOCA_ID|LOCA_NATE|LOCA_GLDT|LOCA_NSRI";
  const std::string loca =
      table("LOCA", with, "|m|yyyy-mm-ddThh:mm|", "ID|2DP|DT|0DP", "BH1|1.00|2026-11-25T10:00|7");
  const std::string unit = table("UNIT", "UNIT_UNIT|UNIT_DESC", "|", "X|X",
                                 "m|metre\nyyyy-mm-dd|date\nyyyy-mm-ddThh:mm|date and time");
  const std::string type = table("TYPE", "TYPE_TYPE|TYPE_DESC", "|", "X|X",
                                 "X|text\nID|name\nDT|date\n2DP|number\n0DP|number");
  std::string newer = kTran;
  newer.replace(newer.find("4.1.1"), 5, "4.2");
  CHECK(broken(kProj + newer + unit + type + loca) == "");
  CHECK(broken(kProj + kTran + unit + type + loca) == "18 9");
}

TEST_CASE("check_ags: a group that appears several times is reported once") {
  const auto other = table("GEOL", "LOCA_ID", "", "ID", "BH1");
  const auto check =
      check_ags(*open_memory("x.ags", kGood + kLoca + kLoca + other + other + other));
  int loca = 0;
  for (const AgsFinding& finding : check.findings)
    loca += finding.text.find("group 'LOCA' appears twice") != std::string::npos ? 1 : 0;
  CHECK(loca == 1);
  CHECK(check.unknown_groups == std::vector<std::string>{"GEOL"});
}

TEST_CASE("check_ags: AGS 3 is refused as such") {
  CHECK_THROWS_WITH(check_ags(*open_memory("x.ags", "\xEF\xBB\xBF\"**PROJ\"\r\n")),
                    Catch::Contains("x.ags:1: this is AGS 3"));
}
