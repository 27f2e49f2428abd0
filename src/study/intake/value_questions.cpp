// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/value_questions.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace triax::study {
namespace {

constexpr std::array<AskedValue, 7> kValues{{
    {"specimen.height_mm",
     "height",
     "height of the specimen",
     "mm",
     {76, 100, 140, 200},
     "The file has a displacement or a volume, but no height. Strains are calculated from it."},
    {"specimen.diameter_mm",
     "diameter",
     "diameter of the specimen",
     "mm",
     {38, 50, 70, 100},
     "The file has a force or a volume, but no diameter. Stresses are calculated from it."},
    {"test.cell_pressure_kPa",
     "cell pressure",
     "held cell pressure",
     "kPa",
     {100, 200, 300, 400},
     "The file has no column for it. Effective stresses are cell pressure less pore pressure. "
     "The usual value is only a guess from the first pore pressure."},
    {"back_pressure",
     "back pressure",
     "back pressure",
     "kPa",
     {0, 100, 200, 300},
     "The file has a cell pressure, but no pore pressure to subtract. The usual value is only a "
     "guess from the first cell pressure."},
    {kConsolidationStress,
     "effective consolidation stress",
     "effective consolidation stress",
     "kPa",
     {100, 200, 300, 400},
     "The file has neither cell pressure nor pore pressure: cell pressure less back pressure at "
     "the start of shear."},
    {"specimen.limit_friction_angle_deg",
     "friction angle",
     "friction angle φ′",
     "°",
     {28, 30, 33, 35},
     ""},
    {"specimen.cohesion_kPa", "cohesion", "cohesion c′", "kPa", {0, 5, 10, 20}, ""},
}};

constexpr double kStep_kPa = 50;
constexpr double kSlenderness = 2;  ///< of the usual specimen, height over diameter

std::string usual_height(const ImportChoices& choices) {
  const WrittenValue* diameter = choices.value("specimen.diameter_mm");
  return fmt::format("{:g}", diameter ? kSlenderness * diameter->value : 76.0);
}

std::string usual_diameter(const lab::Proposal& proposal, const ImportChoices& choices) {
  constexpr double kUsual_mm = 38;
  if (const WrittenValue* height = choices.value("specimen.height_mm"))
    return fmt::format("{:g}", height->value / kSlenderness);
  const lab::LabelValue* height = proposal.label("height");
  return fmt::format("{:g}", height && height->value ? *height->value / kSlenderness : kUsual_mm);
}

/// The first pore pressure and the effective stress above the table, if there is one; else a round
/// pressure at least half a step above the first pore pressure.
std::string usual_cell_pressure(const lab::Proposal& proposal) {
  const double pore = first_value(proposal, "pore_pressure")
                          .value_or(first_value(proposal, "back_pressure").value_or(0));
  for (const char* name : {"effective_consolidation_stress", "cell_pressure"})
    if (const lab::LabelValue* effective = proposal.label(name); effective && effective->value)
      return fmt::format("{:g}", *effective->value + pore);
  return fmt::format("{:g}", kStep_kPa * std::ceil(pore / kStep_kPa + 1));
}

std::string usual_back_pressure(const lab::Proposal& proposal) {
  const double cell = first_value(proposal, "cell_pressure").value_or(0);
  return fmt::format("{:g}", std::max(0.0, kStep_kPa * std::floor(cell / kStep_kPa - 1)));
}

std::string usual_value(const lab::Proposal& proposal, const ImportChoices& choices,
                        const AskedValue& value) {
  if (value.name == "height") return usual_height(choices);
  if (value.name == "diameter") return usual_diameter(proposal, choices);
  if (value.name == "cell pressure") return usual_cell_pressure(proposal);
  if (value.name == "back pressure") return usual_back_pressure(proposal);
  return fmt::format("{:g}", value.usual.front());
}

/// The strains and stresses of the table are used as they are, without dimensions.
bool is_reduced(const lab::Proposal& proposal) {
  const auto has = [&](const char* quantity) { return proposal.has(quantity); };
  return has("axial_strain") &&
         (has("deviator_stress") || has("half_deviator_stress") || has("effective_axial_stress"));
}

}  // namespace

const lab::LabelValue* AskedValue::label(const lab::Proposal& proposal) const {
  if (const auto* const label = proposal.label(key)) return label;
  std::string words(name);
  std::ranges::replace(words, ' ', '_');
  return proposal.label(words);
}

std::span<const AskedValue> asked_values() { return kValues; }

ImportQuestion value_question(const lab::Proposal& proposal, const ImportChoices& choices,
                              std::string_view name) {
  const AskedValue& value = *std::ranges::find(kValues, name, &AskedValue::name);
  return {.about = ImportQuestion::About::value,
          .text = std::string(value.text),
          .explanation = std::string(value.explanation),
          .usual = usual_value(proposal, choices, value),
          .key = std::string(value.key),
          .unit = std::string(value.unit),
          .is_optional = is_reduced(proposal) && (name == "height" || name == "diameter") &&
                         !is_value_open(proposal, choices, name)};
}

bool is_value_open(const lab::Proposal& proposal, const ImportChoices& choices,
                   std::string_view name) {
  const auto has = [&](const char* quantity) { return proposal.has(quantity); };
  const lab::LabelValue* const stated = proposal.label("cell_pressure");
  const bool is_stated = stated && !stated->is_ambiguous &&
                         stated->value > first_value(proposal, "pore_pressure");  // else effective
  const bool has_cell = has("cell_pressure") || choices.constant("cell_pressure") || is_stated;
  if (name == "cell pressure")
    return has("pore_pressure") && !has_cell &&
           std::ranges::none_of(
               std::array{"radial_stress", "axial_stress", "mean_stress", "effective_axial_stress",
                          "effective_radial_stress", "mean_effective_stress",
                          "mean_effective_stress_2d", "stress_ratio", "principal_stress_ratio"},
               has);
  const bool is_raw = has("axial_displacement") && has("axial_force") && has_cell;
  return is_raw && !proposal.label(name) && !choices.has_toml_preamble &&
         !choices.value(fmt::format("specimen.{}_mm", name));
}

}  // namespace triax::study
