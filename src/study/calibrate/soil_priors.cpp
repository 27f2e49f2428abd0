// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/soil_priors.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/base/toml_reader.hpp"

namespace triax::study {
namespace {

struct Source {
  const char* law;      ///< "" for all
  const char* key;      ///< of the law
  const char* section;  ///< of the file, "a.b" for a table in a table
  const char* name;     ///< there
};

constexpr Source kSources[] = {
    {"hypoplastic", "critical_friction_angle_deg", "friction", "critical_friction_angle_deg"},
    {"", "critical_stress_ratio", "friction", "critical_stress_ratio"},
    {"", "extension_ratio", "friction", "extension_ratio"},
    {"norsand", "volumetric_coupling", "friction", "volumetric_coupling"},
    {"norsand", "state_dilatancy", "friction", "state_dilatancy"},
    {"sanisand", "critical_void_ratio", "critical_state_line.power", "critical_void_ratio"},
    {"sanisand", "critical_slope", "critical_state_line.power", "critical_slope"},
    {"sanisand", "critical_exponent", "critical_state_line.power", "critical_exponent"},
    {"norsand", "critical_void_ratio", "critical_state_line.power", "critical_void_ratio"},
    {"norsand", "critical_slope", "critical_state_line.power", "critical_slope"},
    {"norsand", "critical_exponent", "critical_state_line.power", "critical_exponent"},
    {"cam_clay", "compression_slope", "critical_state_line.log_linear", "lambda"},
    {"mohr_coulomb", "friction_angle_deg", "strength", "friction_angle_deg"},
    {"mohr_coulomb", "cohesion_kPa", "strength", "cohesion_kPa"},
};

std::optional<lab::TomlTable> section_of(const lab::TomlTable& root, const std::string& path) {
  const auto dot = path.find('.');
  const auto table = root.table(path.substr(0, dot));
  if (!table || dot == std::string::npos) return table;
  return table->table(path.substr(dot + 1));
}

void take(CalibrationStart& start, const Source& source, double value, double error) {
  start.set.parameters.numbers[source.key] = value;
  start.notes.push_back(fmt::format("{} begins at {:.4g} ± {:.2g}, measured by triax soil",
                                    source.key, value, error));
  const auto range = std::ranges::find(start.free, source.key, &lab::SearchRange::key);
  if (range == start.free.end()) return;
  range->low = std::min(range->low, value);
  range->high = std::max(range->high, value);
  if (error > 0) range->prior = {value, error};
}

}  // namespace

bool is_soil_result(std::string_view text, const std::string& file) {
  const auto root = lab::TomlTable::parse(text, file);
  return root.has("kind") && root.text("kind") == "soil";
}

void take_soil_result(CalibrationStart& start, std::string_view text, const std::string& file) {
  const auto root = lab::TomlTable::parse(text, file);
  const auto& parameters = start.set.law->parameters;
  for (const Source& source : kSources) {
    if (*source.law != '\0' && start.set.law->name != source.law) continue;
    if (std::ranges::find(parameters, source.key, &sim::ParameterDescription::key) ==
        parameters.end())
      continue;
    const auto section = section_of(root, source.section);
    const auto measured = section ? section->table(source.name) : std::nullopt;
    if (measured)
      take(start, source, measured->required_number("value"), measured->required_number("error"));
  }
}

}  // namespace triax::study
