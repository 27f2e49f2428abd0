// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/composed_names.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <string_view>

#include "lab/intake/names/heading_form.hpp"
#include "lab/intake/names/lexicon_quantity.hpp"

using namespace triax::lab;

namespace {

const ComposedNames& composed_names() {
  static const ComposedNames names;
  return names;
}

bool contradicts(std::string_view heading, std::string_view quantity) {
  const auto at = find_lexicon_quantity(quantity) - lexicon_quantities().data();
  return composed_names().find_contradicted(
      heading_tokens(repair_heading(heading)))[static_cast<std::size_t>(at)];
}

/// Names of the quantities with a blank behind each.
std::string find_composed(std::string_view heading) {
  const QuantitySet found = composed_names().find(heading_tokens(repair_heading(heading)));
  std::string text;
  for (std::size_t i = 0; i < lexicon_quantities().size(); ++i)
    if (found[i]) text += lexicon_quantities()[i].name + " ";
  return text;
}

}  // namespace

TEST_CASE("ComposedNames: the order of the words is free") {
  for (const char* heading : {"effective vertical stress", "vertical effective stress",
                              "stress, vertical, effective", "contrainte verticale effective",
                              "Effektive Vertikalspannung", "Вертикальное эффективное напряжение"})
    CHECK(find_composed(heading) == "effective_axial_stress ");
}

TEST_CASE("ComposedNames: a compound is read by its parts") {
  CHECK(find_composed("Porenwasserüberdruck") == "excess_pore_pressure ");
  CHECK(find_composed("Hauptspannungsdifferenz") == "deviator_stress ");
  CHECK(find_composed("有效轴向应力") == "effective_axial_stress ");
  CHECK(find_composed("全側方応力") == "radial_stress ");
  CHECK(find_composed("과잉간극수압") == "excess_pore_pressure ");
}

TEST_CASE("ComposedNames: the beginning of a word is short for it") {
  CHECK(find_composed("Press. interst.") == "pore_pressure ");
  CHECK(find_composed("Esf. desv.") == "deviator_stress ");
  CHECK(find_composed("str. axial") == "axial_strain axial_stress ");  // the unit decides
  CHECK(find_composed("pr").empty());
}

TEST_CASE("ComposedNames: a slash and a preposition do not make another name") {
  CHECK(find_composed("Rapport déviateur/pression moyenne effective") == "stress_ratio ");
  CHECK(find_composed("Druck in der Zelle") == "cell_pressure ");
  CHECK(find_composed("Druck in").empty());  // inches
  CHECK(find_composed("Height of sample at reading") == "specimen_height ");
}

TEST_CASE("ComposedNames: two quantities with the same name are both found") {
  CHECK(find_composed("Axial deformation") == "axial_displacement axial_strain ");
}

TEST_CASE("ComposedNames: a word without a meaning in the name finds nothing") {
  for (const char* heading :
       {"target axial stress", "axial stress rate", "effective", "of the", "", "axial stress q",
        "start time", "pore pressure ratio", "mean cell pressure", "axial radial stress"}) {
    INFO(heading);
    CHECK(find_composed(heading).empty());
  }
}

TEST_CASE("ComposedNames: half, excess and ratio make other quantities") {
  CHECK(find_composed("Half of the deviator stress") == "half_deviator_stress ");
  CHECK(find_composed("主应力差之半") == "half_deviator_stress ");
  CHECK(find_composed("Additional axial stress") == "deviator_stress ");
  CHECK(find_composed("Cell water volume change") == "cell_volume ");
}

TEST_CASE("ComposedNames: a qualifying word contradicts the phrase beside it") {
  CHECK(contradicts("target cell pressure xyz", "cell_pressure"));
  CHECK(contradicts("xyz axial stress ratio", "axial_stress"));
  CHECK(contradicts("x 偏应力的一半", "deviator_stress"));
  CHECK(contradicts("附加轴向应力某", "axial_stress"));  // in a token with an unknown word
  CHECK(contradicts("xyz axial strain increment", "axial_strain"));
  CHECK_FALSE(contradicts("test volume change", "volume_change"));  // a change by its name
  CHECK_FALSE(contradicts("xyz axial force 1", "axial_force"));     // a number, not the largest
  CHECK_FALSE(contradicts("xyz effective axial stress", "effective_axial_stress"));
  CHECK_FALSE(contradicts("xyz axial stress", "axial_stress"));
  CHECK_FALSE(contradicts("xyz ratio", "membrane_and_drain_correction"));  // has no composed name
}

TEST_CASE("ComposedNames: a word of a heading makes it no reading") {
  const auto is_no_reading = [](std::string_view heading) {
    return composed_names().is_no_reading(heading_tokens(repair_heading(heading)));
  };
  CHECK(is_no_reading("xyz target"));
  CHECK(is_no_reading("Sollzelldruck"));
  CHECK(is_no_reading("某设定围压"));          // beside an unknown word
  CHECK_FALSE(is_no_reading("Phasenanfang"));  // not short for Anfangswert
  CHECK_FALSE(is_no_reading("axial force"));
}

TEST_CASE("ComposedNames: a long text finds nothing in short time") {
  std::string text;
  while (text.size() < 100'000) text += "spannungen";
  CHECK(find_composed(text).empty());
  CHECK(find_composed(std::string(1 << 20, ' ') + "\0 x").empty());
}
