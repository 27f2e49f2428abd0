// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/scpi/parameters.hpp"

#include <catch2/catch.hpp>

#include "lab/wire/scpi/scpi_error.hpp"

using namespace triax::lab;

namespace {
int code_of(const std::function<void()>& what) {
  try {
    what();
  } catch (const ScpiError& error) {
    return error.code();
  }
  return 0;
}
double number(const char* text, const char* unit = "") { return ScpiParameters(text).number(unit); }
}  // namespace

TEST_CASE("numbers are read with their unit or without") {
  CHECK(number(" 12 ") == 12);
  CHECK(number("-1.5E3") == -1500);
  CHECK(number("+.5e-1") == 0.05);
  CHECK(number("100 kPa", "kPa") == 100);
  CHECK(number("100KPA", "kPa") == 100);
  CHECK(number("1E2kPa", "kPa") == 100);
  CHECK(number("0.1 mm/min", "mm/min") == 0.1);
  CHECK(code_of([] { number("100 Pa", "kPa"); }) == -131);
  CHECK(code_of([] { number("100 kPa"); }) == -131);
  for (const char* none : {"abc", "1.2.3", "1 2", "\"1\"", "inf", "NaN", "1E999", "kPa", "--1"})
    CHECK(code_of([none] { number(none, "kPa"); }) == -104);
  CHECK(code_of([] { number(""); }) == -109);
  CHECK(code_of([] { ScpiParameters("2.5").integer(0, 9); }) == -222);
  CHECK(code_of([] { ScpiParameters("10").integer(0, 9); }) == -222);
}

TEST_CASE("parameters are parted by commas, not by those of texts, lists and blocks") {
  ScpiParameters all("1, \"a,\"\"b\"\"\",'c',(@101:103,7,5:4), #15a,b\nc ,imm,ON");
  CHECK(all.count() == 7);
  CHECK(all.number() == 1);
  CHECK(all.text() == "a,\"b\"");
  CHECK(all.text() == "c");
  CHECK(all.channels() == std::vector{101, 102, 103, 7, 5, 4});
  CHECK(all.block() == "a,b\nc");
  CHECK(all.word() == "IMM");
  CHECK(all.flag());
  CHECK_FALSE(all.more());
  CHECK(code_of([&] { all.word(); }) == -109);
}

TEST_CASE("what is no list of parameters is told by its code") {
  const std::pair<const char*, int> cases[] = {{"1,,2", -102}, {"1,", -102},     {",1", -102},
                                               {"\"a", -151},  {"#3100a", -161}, {"1,'", -151}};
  for (const auto& [text, code] : cases) CHECK(code_of([&t = text] { ScpiParameters{t}; }) == code);
  CHECK(code_of([] { ScpiParameters("101").channels(); }) == -104);
  CHECK(code_of([] { ScpiParameters("(@a)").channels(); }) == -102);
  CHECK(code_of([] { ScpiParameters("(@1:2:3)").channels(); }) == -102);
  CHECK(code_of([] { ScpiParameters("(@1:2000000000)").channels(); }) == -222);
  CHECK(code_of([] { ScpiParameters("#10x").block(); }) == -104);
  CHECK(code_of([] { ScpiParameters("abc").flag(); }) == -224);
}

TEST_CASE("blocks say their length") {
  CHECK(as_block("(@101,102,103)") == "#214(@101,102,103)");
  CHECK(as_block("") == "#10");
  CHECK(ScpiParameters("#10").block().empty());
  CHECK(block_length("#214x") == 18);
  CHECK(block_length("#0x") == 0);
  CHECK(block_length("#2") == 0);
  CHECK(block_length("#2a4") == 0);
}
