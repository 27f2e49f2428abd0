// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/lexicon.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "tests/lab/intake/names/heading_samples.hpp"

using namespace triax::lab;

namespace {

std::string candidates_text(const HeadingNames& names) {
  std::string text = "'" + names.name + "' [" + names.unit + "]:";
  for (const auto& [quantity, how, lender] : names.candidates)
    text += " " + quantity->name + " " + std::to_string(static_cast<int>(how));
  return text;
}

bool has_candidate(const HeadingNames& names, std::string_view quantity, NameMatch how) {
  return std::ranges::any_of(names.candidates, [&](const NameCandidate& candidate) {
    return candidate.quantity->name == quantity && candidate.how == how;
  });
}

}  // namespace

TEST_CASE("find_names: headings in 13 languages have their quantity and unit") {
  STATIC_REQUIRE(kHeadingSamples.size() >= 150);
  for (const HeadingSample& sample : kHeadingSamples) {
    const HeadingNames names = find_names(sample.heading, sample.unit_of_row);
    INFO(sample.heading << " = " << sample.quantity << "; found " << candidates_text(names));
    REQUIRE_FALSE(names.candidates.empty());
    CHECK(has_candidate(names, sample.quantity, names.candidates.front().how));
    const auto units = find_unit_names(names.unit.empty() ? sample.unit_of_row : names.unit);
    if (sample.unit.empty())
      CHECK(units.empty());
    else
      CHECK(
          std::ranges::any_of(units, [&](const auto* unit) { return unit->name == sample.unit; }));
  }
}

TEST_CASE("find_names: each kind of match is found and comes in its order") {
  struct Case {
    std::string_view heading, quantity;
    NameMatch how;
  };
  for (const auto& [heading, quantity, how] : std::to_array<Case>({
           {"Pore pressure", "pore_pressure", NameMatch::exact},
           {"Target pore pressure", "ignored", NameMatch::kept_word},
           {"Ch2 Pore pressure (calc.)", "pore_pressure", NameMatch::dropped},
           {"Hauptspannungen Porenwasserdruck", "pore_pressure", NameMatch::tail},
           {"Tensione minima σ3'", "effective_radial_stress", NameMatch::symbol},
           {"Vertikalverschiebung s", "axial_displacement", NameMatch::head},
           {"Mid-height pore pressure probe", "pore_pressure", NameMatch::words},
           {"Radial stress", "cell_pressure", NameMatch::borrowed},
       })) {
    const HeadingNames names = find_names(heading);
    INFO(heading << ": " << candidates_text(names));
    CHECK(has_candidate(names, quantity, how));
    CHECK(std::ranges::is_sorted(names.candidates, {}, &NameCandidate::how));
  }
}

TEST_CASE("find_names: a symbol behind a name is stronger than the name, but not a bare letter") {
  for (const auto& [heading, quantity] :
       std::to_array<std::pair<std::string_view, std::string_view>>(
           {{"Pore pressure (Δu)", "excess_pore_pressure"},
            {"Deviator stress (σ1-σ3)m", "deviator_stress_uncorrected"},
            {"Deviator stress (σ1-σ3)", "deviator_stress"},
            {"Cell pressure (σ3)", "cell_pressure"},
            {"Time_stamp_of_reading", "clock"},
            {"LOADCELL_INT", "axial_force"},
            {"Volumetric strain (ε)", "volumetric_strain"}})) {
    const HeadingNames names = find_names(heading);
    INFO(heading << ": " << candidates_text(names));
    REQUIRE_FALSE(names.candidates.empty());
    CHECK(names.candidates.front().quantity->name == quantity);
  }
}

TEST_CASE("find_names: set points, rates and single values are no readings") {
  for (const char* heading : {"Commanded chamber pressure",
                              "Заданные давления в камере",
                              "Reksnelheid axiaal",
                              "Cell pressure reference",
                              "Required back pressure",
                              "Zelldruckvorgabe",
                              "Kraftsollwert",
                              "Contrapresión requerida",
                              "Заданного давления в камере",
                              "控制围压",
                              "側圧指令値",
                              "Kolbengeschwindigkeit",
                              "Cell pressure ramp",
                              "Rate of volume change",
                              "位移速率",
                              "Axial strain per minute",
                              "Initial pore pressure",
                              "Final axial strain",
                              "Осевая деформация при разрушении",
                              "Residual deviator stress",
                              "初期間隙水圧",
                              "Cell pressure noise",
                              "SD of cell pressure",
                              "Axial load limit",
                              "Piston friction",
                              "Predicted deviator stress",
                              "Standardabweichung Axialkraft",
                              "Zeitschritt",
                              "Strain increment",
                              "Deviator stress increment"}) {
    const HeadingNames names = find_names(heading);
    INFO(heading << ": " << candidates_text(names));
    REQUIRE(names.candidates.size() == 1);
    CHECK(names.candidates.front().quantity->name == "ignored");
  }
}

TEST_CASE("find_names: a largest principal stress is no value at a peak") {
  const auto names = find_names("Max. principal stress σ1");
  INFO(candidates_text(names));
  CHECK(has_candidate(names, "axial_stress", NameMatch::tail));
}

TEST_CASE("find_names: an increment, a correction or a rate has no candidate") {
  for (const char* heading :
       {"Load increment (N)", "Incremental axial strain (%)", "Incrément de déformation axiale (%)",
        "轴向应变增量 (%)", "Correction of load (N)", "Correzione di carico (N)",
        "Поправка перемещения (mm)", "Back pressure at start (kPa)", "Piston area (mm2)",
        "最大轴向力 (N)", "Axial strain (%/min)", "Volume change (ml/min)", "Load (kN/s)"}) {
    const HeadingNames names = find_names(heading);
    INFO(candidates_text(names));
    CHECK(names.candidates.empty());
  }
  CHECK(find_names("Increment of volume").candidates.front().quantity->name == "volume_change");
}

TEST_CASE("find_names: an index or a half is no unit and no number of a channel") {
  CHECK(find_names("Deformation ε_v").unit.empty());
  CHECK(find_names("σ_kPa").unit == "kPa");
  CHECK(find_names("主応力差の1/2").candidates.front().quantity->name == "half_deviator_stress");
  CHECK(find_names("主応力差 2").candidates.front().quantity->name == "deviator_stress");
}

TEST_CASE("find_names: the unit decides between quantities with one name") {
  CHECK(find_names("Axial deformation (mm)").candidates.front().quantity->name ==
        "axial_displacement");
  CHECK(find_names("Axial deformation", "%").candidates.front().quantity->name == "axial_strain");
  for (const NameCandidate& candidate : find_names("Load (kPa)").candidates)
    CHECK(candidate.quantity->can_have("pressure"));
}

TEST_CASE("find_names: the unit is separated in each style") {
  for (const char* heading :
       {"Pore pressure (kPa)", "Pore pressure [kPa]", "Pore pressure {kPa}", "Pore pressure <kPa>",
        "Pore pressure, kPa", "Pore pressure / kPa", "Pore pressure in kPa", "Pore_pressure_kPa",
        "Pore pressure kPa", " \"Pore pressure (kPa)\" ", "PorePressure kPa"}) {
    const HeadingNames names = find_names(heading);
    INFO(heading << ": " << candidates_text(names));
    CHECK(names.unit == "kPa");
    CHECK(names.name.starts_with("Pore"));
    CHECK(names.candidates.front().quantity->name == "pore_pressure");
  }
  CHECK(find_names("Pore (kPa)_value").name == "Pore_value");
  CHECK(find_names("sigma_h").unit.empty());
  CHECK(find_names("Ch2 t").unit.empty());
  CHECK(find_names("供試体高さ_in").unit == "in");
}

TEST_CASE("find_names: each quantity is a candidate once") {
  for (const HeadingSample& sample : kHeadingSamples) {
    auto candidates = find_names(sample.heading).candidates;
    std::ranges::sort(candidates, {}, &NameCandidate::quantity);
    INFO(sample.heading);
    CHECK(std::ranges::adjacent_find(candidates, {}, &NameCandidate::quantity) == candidates.end());
  }
}

TEST_CASE("find_names: a text that is no heading has no candidates") {
  const std::string brackets(1 << 20, '(');
  std::string blanks(1 << 20, ' ');
  blanks.back() = 'q';
  const std::string letters(201, 'u');
  for (const std::string_view text :
       std::to_array<std::string_view>({"Zzyzx", "12.34", brackets, blanks, letters})) {
    INFO(text.substr(0, 10));
    CHECK(find_names(text).candidates.empty());
    CHECK(find_names(text, text).candidates.empty());
  }
  CHECK_FALSE(find_names("q", brackets).candidates.empty());
  CHECK(find_names(std::string_view("Pore\0pressure", 13)).candidates.front().quantity->name ==
        "pore_pressure");
}

TEST_CASE("find_names: a heading without a word is a blank column") {
  REQUIRE(find_names("").candidates.size() == 1);
  CHECK(find_names(" - ").candidates.front().quantity->name == "ignored");
}
