// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/diggs_columns.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace triax::lab {
namespace {

using enum Quantity;

struct NamedColumn {
  std::string_view name;  ///< as plain_name() gives it
  Quantity quantity;
};

/// Names of elements of ShearingIncrement, and usual names of properties.
constexpr auto kColumnNames = std::to_array<NamedColumn>({
    {"axialload", axial_force},
    {"axialdeflection", axial_displacement},
    {"axialdeformation", axial_displacement},
    {"deviatoricstress", deviator_stress},
    {"principalstressdifference", deviator_stress},
    {"totalcellpressure", cell_pressure},
    {"chamberpressure", cell_pressure},
    {"confiningpressure", cell_pressure},
    {"totalporewaterpressure", pore_pressure},
    {"totalporepressure", pore_pressure},
    {"porewaterpressure", pore_pressure},
    {"inducedporewaterpressure", excess_pore_pressure},
    {"inducedporepressure", excess_pore_pressure},
    {"excessporewaterpressure", excess_pore_pressure},
    {"effectivemajorprincipalstress", effective_axial_stress},
    {"effectiveminorprincipalstress", effective_radial_stress},
    {"effectiveconfiningstress", effective_radial_stress},
    {"effectivemeanstress", mean_effective_stress},
});

/// Letters in lower case and digits, without text in brackets.
std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name.substr(0, name.find_first_of("([")))
    if (c >= 'A' && c <= 'Z')
      plain += static_cast<char>(c - 'A' + 'a');
    else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
      plain += c;
  return plain;
}

std::optional<DiggsColumn> column_of(std::string_view text) {
  using Role = DiggsColumn::Role;
  const auto name = plain_name(text);
  if (name == "time" || name == "elapsedtime") return DiggsColumn{.role = Role::time};
  if (name == "stage") return DiggsColumn{.role = Role::stage};
  for (const QuantityInfo& one : quantities())
    if (plain_name(one.name) == name) return DiggsColumn{.quantity = one.quantity};
  const auto* const found = std::ranges::find(kColumnNames, name, &NamedColumn::name);
  if (found == kColumnNames.end()) return std::nullopt;
  return DiggsColumn{.quantity = found->quantity};
}

}  // namespace

sim::Unit DiggsColumn::unit() const {
  if (file_unit) return *file_unit;
  if (role == Role::quantity) return *sim::find_unit(info(quantity).unit);
  return *sim::find_unit(role == Role::time ? "s" : "");
}

std::string DiggsColumn::heading() const {
  std::string text(role == Role::stage  ? "stage"
                   : role == Role::time ? "time"
                                        : info(quantity).name);
  if (const auto name = unit().name; !name.empty()) text.append("_").append(name);
  return text;
}

std::optional<DiggsColumn> find_diggs_column(std::string_view property_class,
                                             std::string_view property_name) {
  const auto by_class = column_of(property_class);
  return by_class ? by_class : column_of(property_name);
}

}  // namespace triax::lab
