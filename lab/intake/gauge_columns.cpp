// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/gauge_columns.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "lab/intake/names/unit_names.hpp"

namespace triax::lab {
namespace {

constexpr double kMillimetre = 1e-3;

bool has_any(const Proposal& proposal, std::initializer_list<std::string_view> quantities) {
  return std::ranges::any_of(quantities, [&](auto name) { return proposal.has(name); });
}

/// To SI, of a unit with one of its dimensions.
std::optional<double> si_factor(const std::string& unit, std::string_view dimension) {
  for (const UnitName* one : find_unit_names(unit))
    if (one->dimension == dimension && one->power == 1 && one->offset == 0) return one->factor;
  return std::nullopt;
}

/// The one value of a column of numbers that does not change.
std::optional<double> constant_of(const TableColumn& column) {
  std::optional<double> out;
  for (const double value : column.all) {
    if (std::isnan(value)) continue;
    if (out && *out != value) return std::nullopt;
    out = value;
  }
  return out;
}

/// In SI, of one of its two dimensions.
struct RingFactor {
  std::optional<double> per_division, per_length;
};

std::optional<RingFactor> ring_factor(const Proposal& proposal) {
  const LabelValue* label = proposal.label("ring_factor");
  if (label && label->value && !label->unit.empty()) {  // without a unit it may be any
    const auto per_length = si_factor(label->unit, "force_per_length");
    if (per_length) return RingFactor{{}, *label->value * *per_length};
    return RingFactor{label->value, {}};  // in the unit of the label
  }
  const ColumnMeaning* column = proposal.meaning.of("ring_factor");
  if (column == nullptr) return std::nullopt;
  const auto place = static_cast<std::size_t>(column - proposal.meaning.columns.data());
  const auto value = constant_of(proposal.table.columns[place]);
  if (!value) return std::nullopt;
  const auto times_value = [&](std::optional<double> factor) {
    if (factor) *factor *= *value;
    return factor;
  };
  return RingFactor{times_value(si_factor(column->reading.unit, "force_per_division")),
                    times_value(si_factor(column->reading.unit, "force_per_length"))};
}

/// N per reading of a ring.
std::optional<double> force_scale(const Proposal& proposal, const ColumnReading& reading) {
  const auto factor = ring_factor(proposal);
  if (!factor) return std::nullopt;
  const auto length = si_factor(reading.unit, "length");
  if (!length) return factor->per_division;
  if (!factor->per_length) return std::nullopt;
  return *factor->per_length * *length;
}

/// m per reading of a dial: by its unit, or by the label of the factor for a dial in divisions.
std::optional<double> displacement_scale(const Proposal& proposal, const ColumnReading& reading) {
  if (const auto length = si_factor(reading.unit, "length")) return length;
  const auto units = find_unit_names(reading.unit);
  const bool has_divisions =
      units.empty() || std::ranges::find(units, "division", &UnitName::dimension) != units.end();
  const LabelValue* const label = proposal.label("dial_factor");
  if (!has_divisions || !label || !label->value || !label->is_usual) return std::nullopt;
  if (si_factor(label->unit, "length_per_division")) return *label->value * kMillimetre;
  const auto division = si_factor(label->unit, "length");
  return division ? std::optional(*label->value * *division) : std::nullopt;
}

/// Displacement per division in the unit of its column, by the first and last row; nothing if a row
/// is off by more than the rounding of the printed values.
std::optional<double> displacement_per_division(const TableColumn& dial,
                                                const TableColumn& displacement) {
  constexpr double kRounding = 2;
  const double slope = (displacement.last - displacement.first) / (dial.last - dial.first);
  if (!std::isfinite(slope) || slope == 0) return std::nullopt;
  const double rounding = displacement.sample.half_unit + std::fabs(slope) * dial.sample.half_unit;
  for (std::size_t row = 0; row < dial.all.size(); ++row) {
    const double off =
        displacement.all[row] - displacement.first - slope * (dial.all[row] - dial.first);
    if (std::fabs(off) > kRounding * rounding) return std::nullopt;
  }
  return slope;
}

/// With three digits: divisions are round, the quotient has the rounding of two printed values.
double rounded(double value) {
  const double unit = std::pow(10, std::floor(std::log10(std::fabs(value))) - 2);
  return std::round(value / unit) * unit;
}

}  // namespace

void settle_dial_factor(Proposal& proposal) {
  ColumnReading* dial = nullptr;
  std::size_t dial_at = 0, displacement_at = 0;
  const ColumnReading* displacement = nullptr;
  for (std::size_t i = 0; i < proposal.meaning.columns.size(); ++i) {
    ColumnReading& reading = proposal.meaning.columns[i].reading;
    if (!reading.quantity) continue;
    if (reading.quantity->name == "dial_reading" && reading.unit_source == UnitSource::none) {
      dial = &reading;
      dial_at = i;
    } else if (reading.quantity->name == "axial_displacement") {
      displacement = &reading;
      displacement_at = i;
    }
  }
  if (!dial || !displacement) return;
  const auto& columns = proposal.table.columns;
  const auto slope = displacement_per_division(columns[dial_at], columns[displacement_at]);
  if (!slope) return;
  dial->factor = rounded(std::fabs(*slope) * displacement->factor);
  dial->sign = *slope < 0 ? -1 : 1;
  dial->unit = fmt::format("{:g} mm", dial->factor);
  dial->unit_source = UnitSource::identity;
}

std::vector<GaugeColumn> find_gauge_columns(const Proposal& proposal) {
  std::vector<GaugeColumn> out;
  const bool needs_force =
      !has_any(proposal, {"axial_force", "deviator_stress", "half_deviator_stress", "axial_stress",
                          "effective_axial_stress", "deviator_stress_uncorrected"});
  const bool needs_displacement =
      !has_any(proposal, {"axial_displacement", "axial_strain", "specimen_height"});
  for (std::size_t i = 0; i < proposal.meaning.columns.size(); ++i) {
    const ColumnReading& reading = proposal.meaning.columns[i].reading;
    if (!reading.quantity) continue;
    GaugeColumn gauge{.column = i, .is_force = reading.quantity->name == "force_reading"};
    if (gauge.is_force && needs_force)
      gauge.scale = force_scale(proposal, reading);
    else if (reading.quantity->name == "dial_reading" && needs_displacement)
      gauge.scale = displacement_scale(proposal, reading);
    else
      continue;
    if (gauge.scale) *gauge.scale *= reading.sign;
    out.push_back(gauge);
  }
  return out;
}

}  // namespace triax::lab
