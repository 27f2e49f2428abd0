// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/document_part.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax;
using namespace triax::study;
using Json = nlohmann::ordered_json;

namespace {
const std::string kFile = "f.json";
}  // namespace

TEST_CASE("a part of a document gives values of the right kind and range") {
  const Json json = Json::parse(R"({"x": 1.5, "n": 7, "t": "words", "b": true, "none": null,
                                    "list": [1], "inner": {"y": 2}})");
  const DocumentPart root(json, kFile);
  CHECK(root.number("x") == 1.5);
  CHECK(root.number("n", 7, 7) == 7);
  CHECK(root.whole("n", 0, 7) == 7);
  CHECK(root.text("t") == "words");
  CHECK(root.text("none").empty());
  CHECK(root.flag("b"));
  CHECK_FALSE(root.known("none").has_value());
  CHECK(root.known("x") == 1.5);
  CHECK(root.array("list").size() == 1);
  CHECK(root.part("inner").number("y") == 2);

  CHECK_THROWS_WITH(root["z"], "f.json: z is missing");
  CHECK_THROWS_WITH(root.number("t"), "f.json: t must be a number, -1e+12 to 1e+12");
  CHECK_THROWS_WITH(root.number("x", 2, 3), "f.json: x must be a number, 2 to 3");
  CHECK_THROWS_WITH(root.whole("x", 0, 9), "f.json: x must be an integer, 0 to 9");
  CHECK_THROWS_WITH(root.whole("n", 8, 9), "f.json: n must be an integer, 8 to 9");
  CHECK_THROWS_WITH(root.flag("n"), "f.json: n must be true or false");
  CHECK_THROWS_WITH(root.text("n"), "f.json: n must be a text");
  CHECK_THROWS_WITH(root.array("n"), "f.json: n must be an array");
  CHECK_THROWS_WITH(root.part("list"), "f.json: list: must be an object");
  CHECK_THROWS_WITH(root.part("inner").number("x"), "f.json: inner: x is missing");
}

TEST_CASE("a whole number beyond its type is refused, not wrapped") {
  const Json json = Json::parse(R"({"n": 18446744073709551615, "m": -9223372036854775808})");
  const DocumentPart root(json, kFile);
  CHECK_THROWS_AS(root.whole("n", 0, std::int64_t{1} << 53), lab::BadInput);
  CHECK_THROWS_AS(root.whole("m", 0, 5), lab::BadInput);
}

TEST_CASE("a document is one of its format and version, or says so") {
  const auto read = [](const char* text) {
    return parsed_document(text, kFile, "fine", "is no fine document");
  };
  CHECK(read(R"({"format": "fine", "version": 1})")["version"] == 1);
  CHECK_THROWS_WITH(read("{"), Catch::Contains("f.json: is not a complete JSON document"));
  CHECK_THROWS_WITH(read("[]"), "f.json: is no fine document");
  CHECK_THROWS_WITH(read(R"({"format": "other"})"), "f.json: is no fine document");
  const Json old = read(R"({"format": "fine", "version": 2})");
  CHECK_NOTHROW(require_version(DocumentPart(old, kFile), 2));
  CHECK_THROWS_WITH(require_version(DocumentPart(old, kFile), 1),
                    "f.json: is a piece of format version '2'; this program reads version 1");
}
