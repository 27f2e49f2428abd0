// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/labels.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

using Lines = std::vector<std::vector<std::string>>;

/// The one value with this name.
LabelValue label_of(const Lines& lines, std::string_view name) {
  const auto values = find_labels(lines);
  INFO(lines.front().front() << ": " << name);
  REQUIRE(std::ranges::count(values, name, &LabelValue::name) == 1);
  return *std::ranges::find(values, name, &LabelValue::name);
}

}  // namespace

TEST_CASE("find_labels: the value is in the next cell, with the unit of the label") {
  const LabelValue height = label_of({{"Sample"}, {"Initial Height (cm)", "7.6"}}, "height");
  CHECK(height.metadata == "specimen.height_mm");
  CHECK(height.value == Approx(76));
  CHECK(height.unit == "cm");
  CHECK(height.text == "7.6");
  CHECK(height.line == 2);
  CHECK(height.is_usual);
  CHECK_FALSE(height.is_ambiguous);
  CHECK(find_labels({{"Height", "76"}}, 5).front().line == 5);
}

TEST_CASE("find_labels: the value is read in each style and language") {
  for (const Lines& line : std::vector<Lines>{{{"Initial height: 76 mm"}},
                                              {{"# Altura inicial = 76,0 mm"}},
                                              {{"Anfangshöhe", "", "76,00", "mm"}},
                                              {{"Начальная высота, мм", "76"}},
                                              {{"初始高度（cm）：7.6"}},
                                              {{"初期高さH0(mm)", "76.0"}},
                                              {{"Initial height H0  76.0 mm"}},
                                              {{"Hauteur initiale :", "0,076 m"}},
                                              {{"ilk yükseklik=76mm"}},
                                              {{"H0 = 2.992126 in; D0 = 1.5 in"}},
                                              {{"Client: x; Altezza iniziale: 76 mm"}}})
    CHECK(label_of(line, "height").value == Approx(76).epsilon(1e-6));
}

TEST_CASE("find_labels: several pairs in one line are read") {
  const Lines cells{{"Height (mm)", "140", "", "Diameter (mm)", "70.5", "", "Depth (m)", "3,2"}};
  CHECK(label_of(cells, "height").value == Approx(140));
  CHECK(label_of(cells, "diameter").value == Approx(70.5));
  CHECK(label_of(cells, "depth").value == Approx(3.2));
  const Lines text{{"H0=140mm, D0=70,5mm; Back pressure: 2 bar"}};
  CHECK(label_of(text, "height").value == Approx(140));
  CHECK(label_of(text, "diameter").value == Approx(70.5));
  CHECK(label_of(text, "back_pressure").value == Approx(200));
}

TEST_CASE("find_labels: several pairs in one text are read with any delimiter") {
  for (const Lines& line :
       std::vector<Lines>{{{"Specimen: S1; Diameter: 38.1 mm; Height: 76.2 mm"}},
                          {{"Specimen: S1", "Diameter: 38.1 mm", "Height: 76.2 mm"}},
                          {{"Diameter (mm): 38.1; Height (mm): 76.2"}},
                          {{"Diameter, mm: 38.1 / Height, mm: 76.2"}},
                          {{"Diameter (mm), 38.1, Height (mm), 76.2"}},
                          {{"Diameter (mm),38.1,Height (mm),76.2"}},
                          {{"Specimen S1  Diameter 38.1 mm  Height 76.2 mm"}},
                          {{"Specimen S1", "Diameter 38.1 mm", "Height 76.2 mm"}},
                          {{"Diameter 38.1 mm Height 76.2 mm"}},
                          {{"Diameter (mm)\t38.1\tHeight (mm)\t76.2"}},
                          {{"Specimen: S1 - Diameter: 38.1 mm - Height: 76.2 mm"}},
                          {{"Specimen S1 (Diameter: 38.1 mm, Height: 76.2 mm)"}},
                          {{"Specimen: S1, Diameter 38.1 mm, Height: 76.2 mm"}}}) {
    CHECK(label_of(line, "diameter").value == Approx(38.1));
    CHECK(label_of(line, "height").value == Approx(76.2));
  }
  CHECK(label_of({{"Specimen: S1", "Height: 76 mm"}}, "name").text == "S1");
  CHECK(label_of({{"Specimen: BH1 - 3"}}, "name").text == "BH1 - 3");
}

TEST_CASE("find_labels: values are below a line of labels, but not those of a table") {
  const Lines pair{{"Specimen", "", "Diameter (mm)", "Height (mm)"}, {"S1", "", "38.1", "76.2"}};
  CHECK(label_of(pair, "diameter").value == Approx(38.1));
  CHECK(label_of(pair, "height").value == Approx(76.2));
  CHECK(label_of(pair, "height").line == 2);
  CHECK(label_of(pair, "name").text == "S1");
  Lines table = pair;
  table.push_back({"S2", "", "38.0", "76.0"});
  CHECK(find_labels(table).empty());
}

TEST_CASE("find_labels: dimensions after consolidation are not those as built") {
  for (const char* name :
       {"Height after consolidation (mm)", "Consolidated specimen height, mm",
        "Height at end of consolidation", "Height before shear", "Post-consolidation height",
        "Specimen height after consolidation, Hc (mm)", "Höhe nach der Konsolidierung",
        "Altura después de consolidación", "固结后高度", "圧密後高さ"}) {
    INFO(name);
    const auto values = find_labels({{name, "75.5"}});
    REQUIRE(values.size() == 1);
    CHECK(values[0].name == "consolidated_height");
    CHECK(values[0].value == Approx(75.5));
  }
  CHECK(label_of({{"Area after consolidation: 11.25 cm2"}}, "consolidated_area").value ==
        Approx(1125));
  CHECK(label_of({{"Corrected area (mm2)", "1125"}}, "consolidated_area").value == Approx(1125));
  CHECK(label_of({{"Diameter at start of shear = 37.8 mm"}}, "consolidated_diameter").value ==
        Approx(37.8));
  CHECK(find_labels({{"Final height", "70"}, {"Height after test (mm)", "70"}}).empty());
  CHECK(label_of({{"Diameter before test (mm)", "38"}}, "diameter").value == Approx(38));
}

TEST_CASE("find_labels: values of several specimens in one line are ambiguous") {
  CHECK(label_of({{"Height (mm)", "76.2", "80.0", "76.1"}}, "height").is_ambiguous);
  CHECK_FALSE(label_of({{"Height (mm)", "76.2", "76.1", "76.3"}}, "height").is_ambiguous);
  CHECK_FALSE(label_of({{"Height (mm)", "76.2", "Diameter", "38"}}, "height").is_ambiguous);
}

TEST_CASE("find_labels: a title above values states their state of the specimen") {
  for (const Lines& lines : std::vector<Lines>{
           {{"", "Initial", "After consolidation", "Final"}, {"Height (mm)", "76", "75", "70"}},
           {{"Parameter", "After consolidation:", "Initial"}, {"Height (mm)", "75", "76"}},
           {{"Initial", "", "", "After consolidation"}, {"Height", "76", "", "Height", "75"}},
           {{"Initial"}, {"Height", "76"}, {"After consolidation"}, {"Height", "75"}}}) {
    CHECK(label_of(lines, "height").value == Approx(76));
    CHECK(label_of(lines, "consolidated_height").value == Approx(75));
  }
  const Lines apart{{"After consolidation"}, {"Height: 75 mm"}, {}, {"Height: 76 mm"}};
  CHECK(label_of(apart, "height").value == Approx(76));
}

TEST_CASE("find_labels: texts keep their words") {
  const LabelValue programme = label_of({{"Type of test", "CIUC"}}, "programme");
  CHECK(programme.text == "CIUC");
  CHECK(programme.metadata == "test.programme");
  CHECK_FALSE(programme.value);
  CHECK(label_of({{"Versuchsart: CU; Höhe: 100 mm"}}, "programme").text == "CU");
}

TEST_CASE("find_labels: a number without a unit is as written and may be unusual") {
  const LabelValue height = label_of({{"Initial height", "12.5"}}, "height");
  CHECK(height.value == Approx(12.5));
  CHECK(height.unit.empty());
  CHECK_FALSE(height.is_usual);
  CHECK(label_of({{"Initial volume (mm3)", "86,193"}}, "volume").value == Approx(86193));
}

TEST_CASE("find_labels: the unit decides between labels, else both are found") {
  CHECK(label_of({{"w", "12 %"}}, "water_content").value == Approx(0.12));
  CHECK(label_of({{"w", "150 g"}}, "wet_mass").value == Approx(150));
  const auto both = find_labels({{"w", "15"}});
  CHECK(both.size() == 2);
  CHECK(std::ranges::all_of(both, &LabelValue::is_ambiguous));
}

TEST_CASE("find_labels: headings and readings have no labels") {
  CHECK(find_labels({{"Time (s)", "Height (mm)", "Diameter (mm)", "Cell pressure (kPa)"}}).empty());
  CHECK(find_labels({{"0.0", "1.5", "-3,2"}, {"1.0"}, {""}, {}}).empty());
  CHECK(find_labels({{"Initial height (mm)"}, {"Initial height (mm)", "tall"}}).empty());
  CHECK(find_labels({{"Initial height (mm)", "76 kPa"}}).empty());
}

TEST_CASE("find_labels: hostile cells are read in bounded time") {
  const std::size_t kSize = 1 << 20;
  CHECK(find_labels({{std::string(kSize, ':')}, {std::string(kSize, '=')}}).empty());
  std::string colons("H0\0", 3);
  colons.resize(900, ':');
  CHECK(find_labels({{colons}}).empty());
  CHECK(find_labels({{"H0", std::string(kSize, '9')}}).empty());
  CHECK(find_labels({{"H0", "1e999"}, {"H0", "1e"}, {"H0", "."}, {"H0", "\xFF"}}).empty());
  CHECK(find_labels({std::vector<std::string>(1000, "H0")}).empty());
}

TEST_CASE("find_labels: a letter alone behind a name is its value, not a symbol") {
  for (const char* letter : {"A", "B", "C"})
    CHECK(label_of({{"Specimen:", letter, ""}}, "name").text == letter);
  CHECK(label_of({{"Specimen:", "B", "0.97"}}, "b_value").value == Approx(0.97));
}
