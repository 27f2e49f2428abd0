// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/subjects.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "lab/base/bad_input.hpp"

using namespace triax;

namespace {

std::vector<bench::Subject> read(const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() / "triax_subjects_test.txt";
  std::ofstream(path) << text;
  const auto remove = [&] { std::filesystem::remove(path); };
  try {
    auto subjects = bench::read_subjects(path.string(), "samples/programmes");
    remove();
    return subjects;
  } catch (...) {
    remove();
    throw;
  }
}

}  // namespace

TEST_CASE("a line replaces material and void ratio, - keeps the programme's") {
  const auto s = read("# remark\nicu_6 - - collapse\nicu_6 cam_clay/Hostun-like 1.05 stable\n");
  REQUIRE(s.size() == 2);
  CHECK(s[0].collapses);
  CHECK_FALSE(s[1].collapses);
  CHECK(s[1].programme.material.name == "cam_clay/Hostun-like");
  CHECK(s[1].programme.void_ratio == 1.05);
  CHECK(s[0].programme.void_ratio != 1.05);
}

TEST_CASE("a list that says something else is refused with its line") {
  CHECK_THROWS_WITH(read("icu_6 - - perhaps\n"), Catch::Contains(":1:"));
  CHECK_THROWS_WITH(read("\nicu_6 - loose stable\n"), Catch::Contains(":2:"));
  CHECK_THROWS_AS(read("# nothing\n"), lab::BadInput);
}

TEST_CASE("the shipped list can be read, and holds collapses and controls") {
  const auto s = bench::read_subjects("bench/detection/programmes.txt", "samples/programmes");
  const auto collapsing = std::count_if(s.begin(), s.end(), [](auto& x) { return x.collapses; });
  CHECK(collapsing > 0);
  CHECK(collapsing < std::ssize(s));
}
