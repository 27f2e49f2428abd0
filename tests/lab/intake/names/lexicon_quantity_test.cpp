// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/lexicon_quantity.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

const LexiconQuantity& quantity_of(std::string_view name) {
  const LexiconQuantity* const quantity = find_lexicon_quantity(name);
  REQUIRE(quantity != nullptr);
  return *quantity;
}

const UnitName& unit_of(std::string_view text) {
  const auto units = find_unit_names(text);
  REQUIRE_FALSE(units.empty());
  return *units.front();
}

}  // namespace

TEST_CASE("find_lexicon_quantity: has the properties of the file") {
  const LexiconQuantity& pressure = quantity_of("effective_radial_stress");
  CHECK(pressure.dimension == "pressure");
  CHECK(pressure.unit == "kPa");
  CHECK(pressure.usual == std::pair(-100.0, 2000.0));
  CHECK(pressure.decimals == 1);
  CHECK(pressure.confused_with == std::vector<std::string>{"radial_stress", "cell_pressure"});
  REQUIRE(pressure.sign_hints.size() == 1);
  CHECK(pressure.sign_hints.front().sign == 1);
  CHECK(std::ranges::any_of(pressure.shared_names, [](const SharedName& shared) {
    return shared.quantity == "cell_pressure" && shared.names.empty() &&
           shared.decided_by == "identity";
  }));
  CHECK(quantity_of("cycle").sign_hints.front().factor == 0.5);
  CHECK(find_lexicon_quantity("no_quantity") == nullptr);
  CHECK(find_lexicon_quantity("") == nullptr);
}

TEST_CASE("lexicon_quantities: are sorted, and each other quantity that they name exists") {
  CHECK(std::ranges::is_sorted(lexicon_quantities(), {}, &LexiconQuantity::name));
  CHECK(lexicon_quantities().size() > 40);
  for (const LexiconQuantity& quantity : lexicon_quantities()) {
    INFO(quantity.name);
    for (const std::string& other : quantity.confused_with) CHECK(find_lexicon_quantity(other));
    for (const SharedName& shared : quantity.shared_names)
      CHECK(find_lexicon_quantity(shared.quantity));
  }
}

TEST_CASE("LexiconQuantity: can have its dimension and others of its file") {
  CHECK(quantity_of("pore_pressure").can_have("pressure"));
  CHECK(quantity_of("pore_pressure").can_have("voltage"));
  CHECK_FALSE(quantity_of("pore_pressure").can_have("length"));
  CHECK(quantity_of("ignored").can_have("length"));
}

TEST_CASE("factor_to_canonical: converts to kPa, mm, mm2, mm3, kN, s, degC and plain numbers") {
  struct Case {
    std::string_view quantity, unit;
    double factor;
  };
  for (const auto& [quantity, unit, factor] : std::to_array<Case>({
           {"pore_pressure", "MPa", 1e3},
           {"cell_pressure", "psi", 6.894757293168361},
           {"cell_pressure", "kg/cm2", 98.0665},
           {"axial_displacement", "in", 25.4},
           {"current_area", "cm²", 100},
           {"volume_change", "ml", 1000},
           {"axial_force", "lbf", 0.0044482216152605},
           {"time", "hrs", 3600},
           {"axial_strain", "%", 0.01},
           {"axial_strain", "-", 1},
           {"dial_reading", "div", 1},
       })) {
    INFO(quantity << " in " << unit);
    for (const UnitName* name : find_unit_names(unit))
      if (const auto found = factor_to_canonical(quantity_of(quantity), *name))
        CHECK(*found == Approx(factor).epsilon(1e-12));
    const auto& named = quantity_of(quantity);
    CHECK(std::ranges::any_of(find_unit_names(unit), [&named](const UnitName* name) {
      return factor_to_canonical(named, *name).has_value();
    }));
  }
  CHECK_FALSE(factor_to_canonical(quantity_of("pore_pressure"), unit_of("mm")));
  CHECK_FALSE(factor_to_canonical(quantity_of("pore_pressure"), unit_of("mV")));
}

TEST_CASE("conversion_to_canonical: has the offset of absolute pressures and degrees") {
  const auto absolute = conversion_to_canonical(quantity_of("cell_pressure"), unit_of("psia"));
  REQUIRE(absolute);
  CHECK(absolute->offset == Approx(-101.325));
  const auto fahrenheit = conversion_to_canonical(quantity_of("temperature"), unit_of("°F"));
  REQUIRE(fahrenheit);
  CHECK(212 * fahrenheit->factor + fahrenheit->offset == Approx(100));
  const auto root = conversion_to_canonical(quantity_of("time"), unit_of("√min"));
  REQUIRE(root);
  CHECK(root->power == 2);
  CHECK(root->factor == 60);
}
