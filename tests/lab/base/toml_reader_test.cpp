// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/toml_reader.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

TEST_CASE("values are read by their type, a whole number is a number too") {
  const auto document = TomlTable::parse(
      "name = \"a\"\nn = 3\nx = 0.1\nok = true\nlist = [\"p\", \"q\"]\n[t]\ny = 2.5\n[[s]]\nk = 1\n"
      "[[s]]\nk = 2\n",
      "a.toml");
  CHECK(document.text("name") == "a");
  CHECK(document.integer("n") == 3);
  CHECK(document.number("n") == 3.0);
  CHECK(document.number("x") == 0.1);
  CHECK(document.flag("ok") == true);
  CHECK(document.scalar("x") == "0.1");
  CHECK(document.scalar("n") == "3");
  CHECK(document.texts("list") == std::vector<std::string>{"p", "q"});
  CHECK(document.texts("name") == std::vector<std::string>{"a"});
  CHECK(document.table("t")->number("y") == 2.5);
  CHECK(document.table("t")->name() == "t");
  CHECK(document.tables("s").size() == 2);
  CHECK(document.tables("s")[1].integer("k") == 2);
  CHECK_FALSE(document.number("absent"));
  CHECK(document.keys() == std::vector<std::string>{"name", "n", "x", "ok", "list", "t", "s"});
  CHECK_NOTHROW(document.finish());
}

TEST_CASE("errors name file and line, also for text that begins further down") {
  const auto document = TomlTable::parse("a = 1\nb = \"x\"\n", "a.toml", 10);
  CHECK(document.line("b") == 11);
  CHECK_THROWS_WITH(document.number("b"), "a.toml:11: b: expected a number, without quotes");
  CHECK_THROWS_WITH(TomlTable::parse("a = 1\nb = = 2\n", "a.toml", 10),
                    Catch::StartsWith("a.toml:11: invalid TOML"));
  CHECK_THROWS_AS(TomlTable::read("samples/none.toml"), BadInput);
}

TEST_CASE("a key that nobody asked for is an error with the nearest right key") {
  const auto document = TomlTable::parse("[specimen]\nhight = 1\n", "a.toml");
  const auto table = *document.table("specimen");
  table.number("height");
  table.number("diameter");
  CHECK_THROWS_WITH(table.finish(),
                    Catch::Contains("a.toml:2: unknown key 'hight' in [specimen]") &&
                        Catch::Contains("did you mean 'height'"));
}

TEST_CASE("what must be there is asked for, what was probably meant by another key too") {
  const auto document =
      TomlTable::parse("hieght = 2\nblank = \" \"\n[specimne]\n[t]\na = 1\n", "f.toml");
  CHECK(document.required_number("hieght") == 2);
  CHECK(document.required_table("t").required_number("a") == 1);
  CHECK_THROWS_WITH(document.required_table("specimen"),
                    "f.toml:1: [specimen] is missing; is 'specimne' a misspelling of it?");
  CHECK_THROWS_WITH(document.table("t")->required_text("name"), "f.toml:4: [t]: name is missing");
  CHECK_THROWS_WITH(document.required_text("blank"), "f.toml:2: blank: must not be empty");
  const auto other = TomlTable::parse("hieght = 2\n", "f.toml");
  CHECK_THROWS_WITH(other.required_number("height"),
                    Catch::Contains("is 'hieght' a misspelling of it?"));
}

TEST_CASE("numbers keep to their bounds; infinite and not-a-number are none") {
  const auto document =
      TomlTable::parse("a = 2\nb = inf\nc = nan\nd = 1.5\n[[s]]\nk = 1\n", "f.toml");
  CHECK(document.number("a", {.above = 1, .at_most = 2}) == 2);
  CHECK(document.number("a", {.at_least = 2}) == 2);
  CHECK(document.integer("a", 0, 2) == 2);
  CHECK_THROWS_WITH(document.number("a", {.above = 2}), "f.toml:1: a: is 2, must be above 2");
  CHECK_THROWS_WITH(document.number("d", {.at_least = 2, .at_most = 3}),
                    "f.toml:4: d: is 1.5, must be at least 2 and at most 3");
  CHECK_THROWS_WITH(document.integer("a", 3, 9), "f.toml:1: a: is 2, must be 3 to 9");
  CHECK_THROWS_AS(document.integer("d"), BadInput);
  CHECK_THROWS_AS(document.number("b"), BadInput);
  CHECK_THROWS_AS(document.number("c"), BadInput);
  CHECK_THROWS_WITH(document.tables("s")[0].number("k", {.above = 1}),
                    "f.toml:6: [s 1] k: is 1, must be above 1");
  CHECK_THROWS_AS(document.table("a"), BadInput);
  CHECK_THROWS_AS(document.tables("a"), BadInput);
}

TEST_CASE("a document cannot exhaust the stack") {
  std::string deep = "a";
  for (int i = 0; i < 100'000; ++i) deep += ".a";
  CHECK_THROWS_AS(TomlTable::parse(deep + " = 1", "a.toml"), BadInput);
  CHECK_THROWS_AS(TomlTable::parse("a = " + std::string(100'000, '['), "a.toml"), BadInput);
}

TEST_CASE("quoted text reads back as it was") {
  for (const std::string text : {"plain", "a \"b\" \\ c", "line\nbreak\ttab", "σ ³", ""})
    CHECK(TomlTable::parse("k = " + toml_quoted(text), "a").text("k") == text);
  CHECK(TomlTable::parse("k = " + toml_quoted("mm\xB3"), "a").text("k") == "mm³");
}

TEST_CASE("dots in remarks and texts make nothing deep; those behind them count") {
  const std::string dots(300, '.');
  for (const std::string& text :
       {"# " + dots, "a = \"" + dots + "\"", "a = '" + dots + "'", "a = \"\\\"" + dots + "\"",
        "a = \"\"\"x\"\"" + dots + "\"\"\"\"\"", "a = \'\'\'" + dots + "\n#'" + dots + "\'\'\'"}) {
    INFO(text);
    CHECK_NOTHROW(TomlTable::parse(text, "a.toml"));
  }
  std::string deep = "b";
  for (int i = 0; i < 300; ++i) deep += ".b";
  for (const std::string before :
       {"\"x\".", "'x'.", "x = '' # '\n", "x = \"\"\"\"\"\"\n", "x = \"\\\\\"\n"})
    CHECK_THROWS_WITH(TomlTable::parse(before + deep + " = 1", "a.toml"),
                      Catch::Matchers::Contains("dots"));
}

TEST_CASE("depth counts over lists and tables in one another, not along them") {
  std::string key = "a", deep;
  for (int i = 0; i < 150; ++i) key += ".a";
  for (int i = 0; i < 100; ++i) deep += "x." + key + " = [\n{";
  std::string closed = "x = 1";
  for (int i = 0; i < 100; ++i) closed += "}]";
  CHECK_THROWS_WITH(TomlTable::parse(deep + closed, "a.toml"),
                    Catch::Matchers::Contains("200 deep"));
  std::string wide = "a = [";
  for (int i = 0; i < 1000; ++i) wide += "[0.5, 1.5],\n{b.c = 2.5},";
  CHECK_NOTHROW(TomlTable::parse(wide + "]\n[t.u]\nv.w = 1\n", "a.toml"));
  // Brackets too many at the end: the parser's to refuse.
  CHECK_THROWS_AS(TomlTable::parse("a = []]]]", "a.toml"), BadInput);
}
