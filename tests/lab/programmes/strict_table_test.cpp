#include "lab/programmes/strict_table.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "lab/records/bad_input.hpp"

using namespace triax::lab;
using Catch::Contains;

TEST_CASE("values come out with their type and bounds, or with file and line") {
  const toml::table document = parse_toml("\na = 2\nb = \"x\"\nc = [1]\nd = 1.5\n", "f.toml");
  StrictTable table(document, "f.toml", "[t]");
  CHECK(table.number("a", {.above = 0}) == 2);
  CHECK(table.text("b") == "x");
  CHECK(table.maybe_integer("a", 0, 2) == 2);
  CHECK(table.maybe_array("c")->size() == 1);
  CHECK_FALSE(table.maybe_number("e", {}));
  CHECK_THROWS_WITH(table.number("a", {.above = 2}),
                    Contains("f.toml:2") && Contains("is 2, must be above 2"));
  CHECK_THROWS_WITH(table.number("b", {}), Contains("f.toml:3") && Contains("number"));
  CHECK_THROWS_AS(table.maybe_integer("d", 0, 9), BadInput);
  CHECK_THROWS_AS(table.maybe_table("a"), BadInput);
  CHECK_THROWS_AS(table.number("inf", {}), BadInput);
}

TEST_CASE("a key nobody asked for is refused with the one that was probably meant") {
  const toml::table document = parse_toml("hieght = 2\n", "f.toml");
  StrictTable table(document, "f.toml", "[t]");
  table.maybe_number("height", {});
  CHECK_THROWS_WITH(table.done(), Contains("f.toml:1") && Contains("did you mean height?"));
  CHECK_THROWS_WITH(table.number("height", {}), Contains("is it meant by hieght?"));
}

TEST_CASE("the nearest word is near, or none") {
  const std::vector<std::string> known{"cell_pressure", "back_pressure"};
  CHECK(nearest_word("cell_presure", known) == "cell_pressure");
  CHECK(nearest_word("xyz", known).empty());
  CHECK(nearest_word(std::string(1000, 'c'), known).empty());
}

TEST_CASE("infinite and not-a-number are no numbers of a laboratory") {
  const toml::table document = parse_toml("a = inf\nb = nan\n", "f.toml");
  StrictTable table(document, "f.toml", "[t]");
  CHECK_THROWS_AS(table.number("a", {}), BadInput);
  CHECK_THROWS_AS(table.number("b", {}), BadInput);
}
