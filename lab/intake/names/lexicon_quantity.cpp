// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/lexicon_quantity.hpp"

#include <algorithm>

#include "lab/intake/names/lexicon_file.hpp"

namespace triax::lab {
namespace {

std::optional<int> small_integer(const TomlTable& table, const char* key) {
  const auto value = table.integer(key, -100, 100);
  return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

SharedName read_shared_name(const TomlTable& row, const char* other) {
  return {row.required_text(other), row.texts("exact"), row.required_text("decided_by"),
          row.text("rule").value_or("")};
}

LexiconQuantity read_quantity(const TomlTable& file) {
  LexiconQuantity quantity{.name = file.required_text("quantity"),
                           .dimension = file.required_text("dimension"),
                           .also = file.texts("also"),
                           .unit = file.text("unit").value_or(""),
                           .decimals = small_integer(file, "decimals"),
                           .confused_with = file.texts("confused_with")};
  if (const auto usual = file.numbers("usual"); usual.size() == 2)
    quantity.usual = {usual[0], usual[1]};
  for (const TomlTable& row : file.tables("sign_hint"))
    quantity.sign_hints.push_back({row.texts("names"), small_integer(row, "sign"),
                                   row.number("factor").value_or(1),
                                   row.text("note").value_or("")});
  for (const TomlTable& row : file.tables("borrowed_names"))
    quantity.shared_names.push_back(read_shared_name(row, "from"));
  for (const TomlTable& row : file.tables("shared_with"))
    quantity.shared_names.push_back(read_shared_name(row, "quantity"));
  return quantity;
}

std::vector<LexiconQuantity> read_quantities() {
  std::vector<LexiconQuantity> quantities;
  for (const TomlTable& file : lexicon_quantity_files()) quantities.push_back(read_quantity(file));
  return quantities;
}

}  // namespace

bool LexiconQuantity::can_have(std::string_view other_dimension) const {
  return dimension == "any" || dimension == other_dimension ||
         std::ranges::find(also, other_dimension) != also.end();
}

const std::vector<LexiconQuantity>& lexicon_quantities() {
  static const std::vector<LexiconQuantity> quantities = read_quantities();
  return quantities;
}

const LexiconQuantity* find_lexicon_quantity(std::string_view name) {
  const auto& all = lexicon_quantities();
  const auto found = std::ranges::find(all, name, &LexiconQuantity::name);
  return found == all.end() ? nullptr : &*found;
}

UnitConversion unit_conversion(const UnitName& from, const UnitName& to) {
  return {from.factor / to.factor, (from.offset - to.offset) / to.factor, from.power};
}

std::optional<UnitConversion> conversion_to_canonical(const LexiconQuantity& quantity,
                                                      const UnitName& unit) {
  if (quantity.dimension == "division") return UnitConversion{};
  if (unit.dimension != quantity.dimension) return std::nullopt;
  for (const UnitName* canonical : find_unit_names(quantity.unit.empty() ? "-" : quantity.unit))
    if (canonical->dimension == unit.dimension) return unit_conversion(unit, *canonical);
  return std::nullopt;
}

std::optional<double> factor_to_canonical(const LexiconQuantity& quantity, const UnitName& unit) {
  const auto conversion = conversion_to_canonical(quantity, unit);
  return conversion ? std::optional(conversion->factor) : std::nullopt;
}

}  // namespace triax::lab
