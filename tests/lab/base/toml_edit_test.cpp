// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/toml_edit.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

namespace {

const std::string kText =
    "[test]\nname = \"a\"\nseed = 1\n[[stages]]\nend = [{above = 1.0}, {above = 2.0}]\n"
    "[[stages]]\nrates = [1.0, 2.0]\nfree = false\n";

TomlTable edited(const std::string& key, const std::string& value) {
  return TomlTable::parse(kText, "f", 1, {{key, value}});
}

}  // namespace

TEST_CASE("a value is replaced in tables, lists of tables and lists, the rest stays") {
  CHECK(edited("test.seed", "12").table("test")->integer("seed") == 12);
  CHECK(edited("test.seed", "12").table("test")->text("name") == "a");
  CHECK(
      edited("stages.1.end.2.above", "7.5").tables("stages")[0].tables("end")[1].number("above") ==
      7.5);
  CHECK(edited("stages.2.rates.2", "9").tables("stages")[1].numbers("rates") ==
        std::vector<double>{1, 9});
  CHECK(edited("stages.2.free", "true").tables("stages")[1].flag("free") == true);
}

TEST_CASE("a text stays a text, and a new key becomes what its value looks like") {
  CHECK(edited("test.name", "26").table("test")->text("name") == "26");
  CHECK(edited("test.new", "2.5").table("test")->number("new") == 2.5);
  CHECK(edited("test.new", "word").table("test")->text("new") == "word");
  CHECK(edited("rig.frame.travel_mm", "40").table("rig")->table("frame")->integer("travel_mm") ==
        40);
}

TEST_CASE("a way that does not exist is refused with key and value") {
  for (const auto& [key, words] :
       {std::pair("stages.3.x", "not an item of stages; expected 1 to 2"),
        std::pair("stages.0.x", "expected 1 to"),
        std::pair("stages.first.x", "not an item of stages"),
        std::pair("test.seed.x", "is a value"), std::pair("test", "is a table"),
        std::pair("stages", "is a table"), std::pair("stages.1", "is a table"),
        std::pair("test..x", "part of the key is empty"), std::pair("", "part of the key"),
        std::pair("stages.2.rates.5", "not an item of stages.2.rates; expected 1 to 2")}) {
    INFO(key);
    CHECK_THROWS_WITH(edited(key, "5"), Catch::StartsWith("f: " + std::string(key) + " = 5: ") &&
                                            Catch::Contains(words));
  }
}

TEST_CASE("an unknown key that was put in is found as any other, without a line") {
  const TomlTable table = *edited("test.sed", "5").table("test");
  static_cast<void>(table.text("name"));
  static_cast<void>(table.integer("seed"));
  CHECK_THROWS_WITH(table.finish(), Catch::StartsWith("f: unknown key 'sed'"));
}
