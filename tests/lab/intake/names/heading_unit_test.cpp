// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/heading_unit.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "lab/intake/names/heading_form.hpp"

using namespace triax::lab;

namespace {

/// Name and unit with "|" between them, if `name` is the only name.
std::string split_text(std::string_view text, const QString& name) {
  const auto is_name = [&](const QString& other, const std::vector<const UnitName*>&) {
    return other == name;
  };
  const NameAndUnit parts = split_unit(repair_heading(text), is_name);
  return (parts.name + "|" + parts.unit).toStdString();
}

}  // namespace

TEST_CASE("split_unit: a bracket with a unit is separated whatever the name is") {
  CHECK(split_text("Foo [mm]", "") == "Foo|mm");
  CHECK(split_text("Foo (bar) (mm)", "") == "Foo (bar)|mm");
  CHECK(split_text("Foo (psi(g)) x", "") == "Foo x|psi(g)");
  CHECK(split_text("Foo (corrected)", "") == "Foo (corrected)|");
  CHECK(split_text("Foo (mm", "") == "Foo (mm|");
}

TEST_CASE("split_unit: a unit that can be a word stands behind a name") {
  CHECK(split_text("Foo, mm", "Foo") == "Foo|mm");
  CHECK(split_text("Foo, mm", "Bar") == "Foo|mm");
  CHECK(split_text("Foo t", "Foo") == "Foo|t");
  CHECK(split_text("Foo t", "Bar") == "Foo t|");
  CHECK(split_text("mm", "Bar") == "mm|");
  CHECK(split_text("Foo_mm", "Foo") == "Foo|mm");
  CHECK(split_text("Foo in mm", "Foo") == "Foo|mm");
  CHECK(split_text("Foo / mm", "Foo") == "Foo|mm");
  CHECK(split_text("Foo N/mm²", "Foo") == "Foo|N/mm2");
  CHECK(split_text("FooMM", "Foo") == "Foo|MM");
  CHECK(split_text("Foo m/m", "Foo") == "Foo|m/m");
  CHECK(split_text("Foo ratio", "Foo") == "Foo ratio|");
  CHECK(split_text("Foo mm", "Foo mm") == "Foo mm|");
}
