// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/labels_above.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>

using namespace triax::lab;

namespace {

using Lines = std::vector<std::string>;

std::optional<double> value_of(const std::vector<LabelValue>& labels, std::string_view name) {
  const auto found = std::ranges::find(labels, name, &LabelValue::name);
  if (found == labels.end() || found->is_ambiguous) return std::nullopt;
  return found->value;
}

std::string programme_of(const Lines& lines) {
  const auto labels = labels_above(lines, Separator::comma);
  const auto found = std::ranges::find(labels, "programme", &LabelValue::name);
  return found == labels.end() ? "" : found->text;
}

/// Two tables of two columns side by side, with an empty column between them.
TableStructure side_by_side(Lines preamble) {
  TableStructure out;
  out.preamble = std::move(preamble);
  out.blocks = {{.first_cell = 0, .cell_count = 2, .title = {}},
                {.first_cell = 3, .cell_count = 2, .title = {}}};
  return out;
}

}  // namespace

TEST_CASE("labels_above: two values of one number make it ambiguous") {
  const auto labels = labels_above({"Height,76.2", "Height: 80 mm"}, Separator::comma);
  REQUIRE(labels.size() == 2);
  CHECK(labels[0].is_ambiguous);
  CHECK(labels[1].is_ambiguous);
  const auto same = labels_above({"Height (mm),76.2", "Height: 3.00 in"}, Separator::comma);
  REQUIRE(same.size() == 1);
  CHECK(value_of(same, "height") == Approx(76.2));
}

TEST_CASE("labels_above: the diameter follows from the area or the volume") {
  const auto area =
      labels_above({"Height (mm),76.2", "Initial area (mm2),1140.09"}, Separator::comma);
  CHECK(value_of(area, "diameter").value_or(0) == Approx(38.1).epsilon(1e-5));
  const auto volume =
      labels_above({"Height (mm),76.2", "Initial volume (cm3),86.8749"}, Separator::comma);
  CHECK(value_of(volume, "diameter").value_or(0) == Approx(38.1).epsilon(1e-5));
  const auto stated =
      labels_above({"Diameter (mm),38", "Initial area (mm2),1140.09"}, Separator::comma);
  CHECK(value_of(stated, "diameter") == 38);
  CHECK_FALSE(value_of(labels_above({"Initial volume,86.9"}, Separator::comma), "diameter"));
}

TEST_CASE("labels_above: the type of the test is that of a title if no label states it") {
  CHECK(programme_of({"Consolidated undrained triaxial compression test, ASTM D4767"}) == "CU");
  CHECK(programme_of({"Client,X", "UU test BS 1377-7", "Height,76"}) == "UU");
  CHECK(programme_of({"CU triaxial test", "Test type: CID"}) == "CID");
  CHECK(programme_of({"Triaxial test report", "Client,X"}).empty());
}

TEST_CASE("labels_above: a block has the labels above it and those common to all") {
  const TableStructure table = side_by_side({"Specific gravity,2.65", "Specimen,S1,,Specimen,S2",
                                             "Height: 76 mm,,,Height: 80 mm", ",,,Void ratio,0.7"});
  const auto first = labels_above(table, 1), second = labels_above(table, 2);
  CHECK(value_of(first, "height") == 76);
  CHECK(value_of(second, "height") == 80);
  CHECK_FALSE(value_of(first, "void_ratio"));
  CHECK(value_of(second, "void_ratio") == 0.7);
  for (const auto& labels : {first, second}) CHECK(value_of(labels, "specific_gravity") == 2.65);
  const auto name_of = [](const std::vector<LabelValue>& labels) {
    return std::ranges::find(labels, "name", &LabelValue::name)->text;
  };
  CHECK(name_of(first) == "S1");
  CHECK(name_of(second) == "S2");
}
