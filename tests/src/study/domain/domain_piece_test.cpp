// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_piece.hpp"
#include "src/domain/domain_text.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lab/base/bad_input.hpp"
#include "tests/src/sample_domain.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;
using Catch::Contains;
using Json = nlohmann::ordered_json;

namespace {

std::string piece(int index) { return piece_json(sample_domain({index - 1}), index, 3); }

std::vector<DomainPiece> all_pieces() {
  return {read_piece(piece(3), "c.json"), read_piece(piece(1), "a.json"),
          read_piece(piece(2), "b.json")};
}

/// The message of the refusal of piece 2 after this change.
template <class Change>
std::string refusal(const Change& change) {
  Json document = Json::parse(piece(2));
  change(document);
  try {
    read_piece(document.dump(), "b.json");
  } catch (const lab::BadInput& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("pieces that were written and read are the run in one go to the byte") {
  const ReportedDomain whole = sample_domain(), together = merged(all_pieces());
  CHECK(domain_json(together) == domain_json(whole));
  CHECK(domain_states_csv(together) == domain_states_csv(whole));
  CHECK(domain_boundaries_csv(together) == domain_boundaries_csv(whole));
  CHECK(domain_text(together) == domain_text(whole));
}

TEST_CASE("a piece that is missing, twice or of something else is named") {
  auto pieces = all_pieces();
  pieces.erase(pieces.begin());
  CHECK_THROWS_WITH(merged(pieces), "--merge: piece 3 of 3 is missing (2 given)");
  pieces.push_back(read_piece(piece(1), "again.json"));
  CHECK_THROWS_WITH(merged(pieces), Contains("again.json: is piece 1 of 3, like a.json"));

  const auto changed = [](const auto& change) {
    auto some = all_pieces();
    change(some[2]);
    return some;
  };
  CHECK_THROWS_WITH(merged(changed([](DomainPiece& p) { p.count = 4; })),
                    Contains("b.json: is one of 4 pieces, c.json one of 3"));
  CHECK_THROWS_WITH(
      merged(changed([](DomainPiece& p) { p.domain.settings.grid.void_ratio = 1.0; })),
      Contains("b.json") && Contains("grid void_ratio is 1.0, in c.json 1.086"));
  CHECK_THROWS_WITH(merged(changed([](DomainPiece& p) {
                      p.domain.settings.material.parameters[0].second = "9";
                    })),
                    Contains("material parameters"));
  CHECK_THROWS_WITH(merged(changed([](DomainPiece& p) { p.program = "0.0.1"; })),
                    Contains("was written by triax 0.0.1"));
}

TEST_CASE("what is no whole piece is refused in one line that names the file") {
  const std::string good = piece(2);
  CHECK(refusal([](Json&) {}).empty());
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{1}, good.size() / 2, good.size() - 3})
    CHECK_THROWS_WITH(read_piece(good.substr(0, length), "b.json"),
                      Contains("b.json: is not a complete JSON document"));
  for (const char* foreign : {"{}", "[]", "1", "null", "{\"format\": 3}"})
    CHECK_THROWS_WITH(read_piece(foreign, "b.json"),
                      Contains("b.json: is not a piece of a domain"));
  CHECK_THROWS_WITH(read_piece(domain_json(sample_domain()), "b.json"),
                    Contains("is not a piece of a domain"));

  using Catch::Matchers::StdString::ContainsMatcher;
  const auto says = [](const std::string& message, const char* words) {
    INFO(message);
    CHECK(message.rfind("b.json: ", 0) == 0);
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.find(words) != std::string::npos);
  };
  says(refusal([](Json& d) { d["version"] = 2; }), "format version '2'");
  says(refusal([](Json& d) { d["version"] = "one\ntwo"; }), "this program reads version 1");
  says(refusal([](Json& d) { d.erase("grid"); }), "grid is missing");
  says(refusal([](Json& d) { d["grid"] = 1; }), "grid: must be an object");
  says(refusal([](Json& d) { d["grid"]["rows"] = 1e9; }), "rows must be an integer");
  says(refusal([](Json& d) { d["grid"]["rows"] = 9999; }), "has 12 states");
  says(refusal([](Json& d) { d["grid"]["p_from_kPa"] = -1; }), "p' from -1");
  says(refusal([](Json& d) { d["grid"]["plane"] = "oblique"; }), "'oblique' is not a plane");
  says(refusal([](Json& d) { d["piece"]["index"] = 4; }), "index must be an integer, 1 to 3");
  says(refusal([](Json& d) { d["piece"]["index"] = 1; }), "column must be 0");
  says(refusal([](Json& d) { d["columns"].clear(); }), "has 0 columns");
  says(refusal([](Json& d) { d["columns"][0]["p_eff_kPa"] = 99; }), "p_eff_kPa must be 100");
  says(refusal([](Json& d) { d["columns"][0]["states"].erase(0); }), "has 11 states");
  says(refusal([](Json& d) { d["columns"][0]["states"][1]["q_kPa"] = 0; }), "as in the grid");
  says(refusal([](Json& d) { d["columns"][0]["states"][1]["kind"] = "odd"; }),
       "'odd' is not a kind of state");
  says(refusal([](Json& d) { d["columns"][0]["states"][1]["cones"] = 5; }),
       "cones must be an array");
  says(refusal([](Json& d) { d["columns"][0]["compression"]["limit"] = "x"; }),
       "columns[0] compression limit: must be an object");
  says(refusal([](Json& d) { d["material"]["parameters"]["poisson_ratio"] = 0.1; }),
       "poisson_ratio must be a text");
  says(refusal([](Json& d) { d["warnings"] = {1}; }), "warnings must be texts");
}

TEST_CASE("a deep or odd document does no harm") {
  CHECK_THROWS_AS(read_piece(std::string(100000, '['), "b.json"), lab::BadInput);
  CHECK_THROWS_AS(read_piece("{\"format\": 1e999}", "b.json"), lab::BadInput);
  CHECK_THROWS_AS(read_piece("\xff\xfe", "b.json"), lab::BadInput);
}

TEST_CASE("a piece is read from its file, which must be one") {
  const auto file = std::filesystem::temp_directory_path() / "triax_piece_test.json";
  std::ofstream(file) << piece(2);
  const DomainPiece read = load_piece(file.string());
  CHECK(read.index == 2);
  CHECK(read.count == 3);
  CHECK(read.file == file.string());
  CHECK(read.domain.columns.at(0).column == 1);
  std::filesystem::remove(file);
  CHECK_THROWS_WITH(load_piece(file.string()), Contains("file does not exist"));
  CHECK_THROWS_WITH(load_piece("."), Contains("is not a regular file"));
}

TEST_CASE("the bounds of a grid are told before anything is computed") {
  const DomainSettings::Grid good = sample_domain({}).settings.grid;
  CHECK_NOTHROW(check_grid(good, "the grid"));
  const auto bad = [&](const auto& change, const char* words) {
    auto grid = good;
    change(grid);
    CHECK_THROWS_WITH(check_grid(grid, "the grid"), Contains("the grid: ") && Contains(words));
  };
  bad([](auto& g) { g.columns = 0; }, "0 x 12 states");
  bad([](auto& g) { g.columns = g.rows = 10000; }, "at most 4000000");
  bad([](auto& g) { g.p_from_kPa = 0; }, "p' from 0");
  bad([](auto& g) { g.p_to_kPa = 40; }, "must increase");
  bad([](auto& g) { g.q_to_kPa = -300; }, "q from -140 to -300");
  bad([](auto& g) { g.void_ratio = 0; }, "void ratio 0");
  bad([](auto& g) { g.directions = 7; }, "7 directions");
}

TEST_CASE("the fuzzer's seeds are pieces") {
  int seeds = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator("tests/fuzz/seeds/domain_piece_fuzz")) {
    CHECK_NOTHROW(load_piece(entry.path().string()));
    ++seeds;
  }
  CHECK(seeds >= 2);
}
