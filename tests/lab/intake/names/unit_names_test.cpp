// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/unit_names.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <string>

using namespace triax::lab;

namespace {

std::set<std::string> names_of(std::string_view text) {
  std::set<std::string> names;
  for (const UnitName* unit : find_unit_names(text)) names.insert(unit->name);
  return names;
}

}  // namespace

TEST_CASE("find_unit_names: letter case, brackets, superscripts and blanks do not matter") {
  for (const char* text : {"kPa", "KPA", "[kpa]", "(kPa)", " kN/m² ", "kN/m^2", "KN/M2", "kn / m 2",
                           "千帕", "кПа", "㎪", "ＫＰａ"}) {
    INFO(text);
    CHECK(names_of(text) == std::set<std::string>{"kPa"});
  }
  CHECK(names_of("in.") == std::set<std::string>{"in"});
  CHECK(names_of("lbf/in.²") == std::set<std::string>{"psi"});
  CHECK(names_of("mm3") == std::set<std::string>{"mm3"});
  CHECK(names_of("Â°C") == std::set<std::string>{"degC"});
}

TEST_CASE("find_unit_names: a unit has a factor to SI, an offset and a power") {
  const auto units = find_unit_names("psia");
  REQUIRE(units.size() == 1);
  CHECK(units.front()->dimension == "pressure");
  CHECK(units.front()->factor == Approx(6894.757293168361));
  CHECK(units.front()->offset == -101325);
  CHECK(units.front()->power == 1);
  CHECK(find_unit_names("√min").front()->power == 2);
}

TEST_CASE("find_unit_names: an ambiguous spelling says so and has every meaning") {
  CHECK(names_of("kg") == std::set<std::string>{"kg", "kgf"});
  for (const UnitName* unit : find_unit_names("kg")) {
    CHECK(unit->is_ambiguous);
    CHECK_FALSE(unit->decided_by.empty());
  }
  CHECK_FALSE(find_unit_names("kgf").front()->is_ambiguous);
  CHECK(find_unit_names("V").front()->is_ambiguous);
  CHECK_FALSE(find_unit_names("volt").front()->is_ambiguous);
  CHECK_FALSE(find_unit_names("-").front()->can_end_heading);
}

TEST_CASE("find_unit_names: a text that is no unit has none") {
  const std::string letters(1 << 20, 'k');
  for (const std::string_view text : std::to_array<std::string_view>(
           {"", " ", "()", "pressure", std::string_view("k\0Pa", 4), letters, "\xFF"}))
    CHECK(find_unit_names(text).empty());
}
