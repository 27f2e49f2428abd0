// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/soil_priors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "src/study/calibrate/search_space.hpp"

namespace triax::study {
namespace {

struct Source {
  const char* law;           ///< "" for all
  const char* key;           ///< of the law
  std::string_view section;  ///< of the file, "a.b" for a table in a table
  const char* name;          ///< there
};

constexpr auto kSources = std::to_array<Source>({
    {"hypoplastic", "critical_friction_angle_deg", "friction", "critical_friction_angle_deg"},
    {"", "critical_stress_ratio", "friction", "critical_stress_ratio"},
    {"", "extension_ratio", "friction", "extension_ratio"},
    {"norsand", "volumetric_coupling", "friction", "volumetric_coupling"},
    // Not state_dilatancy: soil gives it over ψ₀, the law's acts on the state near the peak.
    {"sanisand", "critical_void_ratio", "critical_state_line.power", "critical_void_ratio"},
    {"sanisand", "critical_slope", "critical_state_line.power", "critical_slope"},
    {"sanisand", "critical_exponent", "critical_state_line.power", "critical_exponent"},
    {"norsand", "critical_void_ratio", "critical_state_line.power", "critical_void_ratio"},
    {"norsand", "critical_slope", "critical_state_line.power", "critical_slope"},
    {"norsand", "critical_exponent", "critical_state_line.power", "critical_exponent"},
    {"cam_clay", "compression_slope", "critical_state_line.log_linear", "lambda"},
    {"mohr_coulomb", "friction_angle_deg", "strength", "friction_angle_deg"},
    {"mohr_coulomb", "cohesion_kPa", "strength", "cohesion_kPa"},
});

std::optional<lab::TomlTable> section_of(const lab::TomlTable& root, std::string_view path) {
  const auto dot = path.find('.');
  auto table = root.table(path.substr(0, dot));
  if (!table || dot == std::string::npos) return table;
  return table->table(path.substr(dot + 1));
}

/// The law's number for the pressure at which a power line has its slope.
constexpr auto kPressures = std::to_array<Source>({
    {"norsand", "critical_pressure_kPa", "critical_state_line.power", "critical_pressure_kPa"},
    {"sanisand", "atmospheric_pressure_kPa", "critical_state_line.power", "critical_pressure_kPa"},
});

const sim::ParameterDescription* parameter_of(const sim::LawDescription& law, const Source& from) {
  if (*from.law != '\0' && law.name != from.law) return nullptr;
  const auto found = std::ranges::find(law.parameters, from.key, &sim::ParameterDescription::key);
  return found == law.parameters.end() ? nullptr : &*found;
}

/// A slope means something at its pressure only. SANISAND's is that of its moduli too, which are
/// not measured here: a line at another one is not taken.
bool same_pressure(CalibrationStart& start, const lab::TomlTable& root) {
  for (const Source& source : kPressures) {
    const auto* parameter = parameter_of(*start.set.law, source);
    const auto section = section_of(root, source.section);
    const auto measured = section ? section->number(source.name) : std::nullopt;
    if (parameter == nullptr || !measured) continue;
    const double own = value_of(start.set, source.key).value_or(*measured);
    if (own == *measured) continue;
    if (start.set.law->name == "sanisand" || !parameter->range.holds(*measured)) {
      start.notes.push_back(fmt::format(
          "the critical state line of triax soil is not used: its pressure is {:g} kPa, {} {:g}",
          *measured, source.key, own));
      return false;
    }
    start.set.parameters.numbers[source.key] = *measured;
    start.notes.push_back(fmt::format("{} is {:g}, as in triax soil", source.key, *measured));
  }
  return true;
}

void take(CalibrationStart& start, const Source& source, const sim::Range& possible, double value,
          double error) {
  if (!possible.holds(value)) {
    start.notes.push_back(fmt::format(
        "{} {:.4g} ± {:.2g}, measured by triax soil, is not used: the law needs a number {}",
        source.key, value, error, possible.words()));
    return;
  }
  start.set.parameters.numbers[source.key] = value;
  start.notes.push_back(fmt::format("{} begins at {:.4g} ± {:.2g}, measured by triax soil",
                                    source.key, value, error));
  const auto range = std::ranges::find(start.free, source.key, &lab::SearchRange::key);
  if (range == start.free.end()) return;
  range->low = std::min(range->low, value);
  range->high = std::max(range->high, value);
  range->in_logarithm = lab::is_of_ratios(range->low, range->high);
  if (error > 0) range->prior = {value, error};
}

}  // namespace

bool is_soil_result(const lab::TomlTable& root) {
  return root.has("kind") && root.text("kind") == "soil";
}

void take_soil_result(CalibrationStart& start, const lab::TomlTable& root) {
  const bool with_line = same_pressure(start, root);
  for (const Source& source : kSources) {
    const auto* parameter = parameter_of(*start.set.law, source);
    if (parameter == nullptr || (!with_line && source.section == kPressures.front().section))
      continue;
    const auto section = section_of(root, source.section);
    const auto measured = section ? section->table(source.name) : std::nullopt;
    if (measured)
      take(start, source, parameter->range, measured->required_number("value"),
           measured->required_number("error"));
  }
}

}  // namespace triax::study
