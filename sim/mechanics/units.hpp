// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Units at the border: everything inside is SI (Pa, m, m³, N, s, plain numbers); files, tables and
// wires carry units of the field, and the unit is always part of the name.
#include <optional>
#include <string_view>

namespace triax::sim {

enum class Dimension { none, time, length, volume, area, force, pressure, angle, mass, density };

/// A unit of the field: one unit is `scale` SI units.
struct Unit {
  std::string_view name;  ///< as written in names and headings: "kPa", "mm3"
  Dimension dimension = Dimension::none;
  double scale = 1;
};

/// The unit of that name or of one of its usual spellings ("kN/m2", "mm^3", "%", "min", "kgf/cm2");
/// nothing if the name is unknown. Case matters (MPa is not mPa).
std::optional<Unit> find_unit(std::string_view name);

/// A value in the field's unit as SI. Both a simulated scan and a parsed one go through this one
/// multiplication, which is what makes replay bit-exact.
constexpr double to_si(double field_value, const Unit& unit) { return field_value * unit.scale; }

/// The value in the field's unit from which to_si gives back exactly `si`, where one exists within
/// one unit in the last place of si/scale; else the nearest. Among several the one with the
/// shortest decimal text is returned, so that 500.12 kPa is written as 500.12.
double to_field(double si, const Unit& unit);

}  // namespace triax::sim
