// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/element/path_text.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "lab/paths/path_reader.hpp"
#include "src/element/path_csv.hpp"
#include "src/element/path_json.hpp"
#include "src/study/element/run_element.hpp"
#include "tests/lab/paths/path_text.hpp"

using namespace triax;
using nlohmann::json;

namespace {

study::PathResult result_of(const std::string& toml) {
  return study::run_element(lab::read_path(toml, "p.toml"));
}

}  // namespace

TEST_CASE("columns in their units, unknown as null and empty") {
  auto result = result_of(lab::test::kPath);
  REQUIRE(result.went_to_the_end());
  CHECK(result.value(result.start, "p_eff_kPa") == 100.0);
  CHECK(result.value(result.start, "void_ratio") == 1.0);
  CHECK_FALSE(result.value(result.start, "nothing_of_this_name"));
  CHECK(result.last.segment == "compression");
  CHECK(result.columns.size() == result.last.values.size());
  CHECK(result.columns.back().rfind("memory.", 0) == 0);

  result.rows.front().values[3].reset();
  const json d = json::parse(src::path_json(result));
  CHECK(d["rows"][0][result.columns[3]].is_null());
  CHECK(d["rows"][1][result.columns[3]].is_number());
  CHECK(d["rows"][0].size() == result.columns.size() + 1);
  const std::string csv = src::path_csv(result);
  CHECK(csv.find(",,") != std::string::npos);
  CHECK(csv.find("\"compression\",0,") != std::string::npos);
}

TEST_CASE("names of a path cannot command a terminal or break a table") {
  const auto result =
      result_of(lab::test::with(lab::test::with(lab::test::kPath, "\"small\"", R"("a\u001Bb\nc")"),
                                "\"compression\"", R"("x \"y\",\u001Bz")"));
  CHECK(src::path_text(result).find('\x1b') == std::string::npos);
  const std::string csv = src::path_csv(result);
  CHECK(csv.find("\"x \"\"y\"\", z\",") != std::string::npos);
  CHECK(csv.find('\x1b') == std::string::npos);
}
