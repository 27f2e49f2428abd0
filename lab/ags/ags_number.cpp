// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/ags_number.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

constexpr double kGravity = 9.80665;     // m/s²
constexpr double kDensestSoil = 10'000;  // kg/m³; iron ore has half of that

/// Spellings of deliveries beside those that sim::find_unit knows, folded.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kSpellings{
    {{"kpa", "kPa"},
     {"kn/m2", "kPa"},
     {"kn/m²", "kPa"},
     {"degrees", "deg"},
     {"degree", "deg"},
     {"% w/w", "%"},
     {"metres", "m"},
     {"none", "-"},
     {"tonne/m3", "t/m3"}}};

bool is_unit_weight(std::string_view unit) {
  return unit == "kN/m3" || unit == "kN/m³" || unit == "kN/m^3";
}

std::optional<sim::Unit> known_unit(const std::string& text) {
  if (is_unit_weight(text)) return sim::Unit{"kN/m3", sim::Dimension::density, 1e3 / kGravity};
  if (const auto unit = sim::find_unit(text)) return unit;
  for (const auto& [spelling, unit] : kSpellings)
    if (folded(text) == spelling) return sim::find_unit(unit);
  return std::nullopt;
}

/// With the leading + that some write.
std::optional<double> finite_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto value = whole_text_as<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace

sim::Unit AgsNumbers::unit_of(const std::string& heading, const std::string& given,
                              std::string_view usual) {
  const sim::Unit expected = *sim::find_unit(usual);
  if (given.empty()) {
    if (!usual.empty())
      findings_.note("unit " + heading, reader_.line(),
                     fmt::format("{} has no unit; read as {}, the unit of the AGS4 dictionary",
                                 heading, usual));
    return expected;
  }
  const auto unit = known_unit(given);
  const bool fits = unit && unit->dimension == expected.dimension;
  if (!fits)
    throw BadInput(
        reader_.file(), reader_.group().unit_line,
        fmt::format("{} is in {}, {}; the AGS4 dictionary has {}", heading, excerpt(given),
                    unit ? "which does not fit this quantity" : "an unknown unit",
                    usual.empty() ? "no unit" : usual));
  if (unit->name == "kN/m3")
    findings_.note(
        "unit weight", reader_.line(),
        fmt::format("{} is a unit weight in kN/m3; divided by g = 9.80665 m/s2", heading));
  return *unit;
}

std::optional<double> AgsNumbers::si(std::string_view heading, std::string_view usual) {
  const std::string_view text = reader_.cell(heading);
  if (text.empty()) return std::nullopt;
  const std::string name(heading);
  const auto value = finite_number(text);
  if (!value) {
    findings_.note("no number " + name, reader_.line(),
                   fmt::format("{} is {}, which is not a number; ignored", name, excerpt(text)));
    return std::nullopt;
  }
  const auto column = reader_.group().find(heading);
  const sim::Unit unit = unit_of(name, reader_.group().headings[*column].unit, usual);
  const double si = sim::to_si(*value, unit);
  if (!std::isfinite(si)) return std::nullopt;
  if (unit.dimension == sim::Dimension::density && si > kDensestSoil) {
    findings_.note(
        "dense " + name, reader_.line(),
        fmt::format("{} is {} {}, which is impossible for soil (a unit weight in kN/m3?); ignored",
                    name, text, unit.name));
    return std::nullopt;
  }
  return si;
}

}  // namespace triax::lab
