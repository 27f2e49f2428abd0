// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/questions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "lab/intake/gauge_columns.hpp"

namespace triax::lab {
namespace {

using About = TableQuestion::About;

bool is_unused(const ColumnReading& reading) {
  return !reading.quantity || reading.quantity->dimension == "any" ||
         reading.quantity->dimension == "text";
}

/// Quantities that no result depends on.
bool is_auxiliary(const ColumnReading& reading) {
  constexpr std::array kNames{"temperature", "reading_number", "force_reading", "dial_reading",
                              "cell_volume", "text",           "ignored",       "ring_factor"};
  return std::ranges::find(kNames, reading.quantity->name) != kNames.end();
}

/// p′, q or s′, t: one question for both columns.
bool is_definition(const ColumnReading& a, const ColumnReading& b) {
  constexpr std::array kNames{"half_deviator_stress", "mean_effective_stress_2d"};
  return std::ranges::any_of(kNames, [&](const char* name) {
    return a.quantity->name == name || b.quantity->name == name;
  });
}

/// Laboratories count it either way.
bool usual_is_open(const ColumnReading& reading) {
  return reading.quantity->name == "volume_change";
}

/// Only the sign of the column is not decided.
bool is_sign_open(const ColumnMeaning& meaning) {
  return !meaning.is_decided() && meaning.other->quantity == meaning.reading.quantity &&
         meaning.other->factor == meaning.reading.factor;
}

bool is_volume(const ColumnReading& reading) {
  return reading.quantity->name == "volume_change" || reading.quantity->name == "back_volume";
}

/// A displacement, or the readings of its dial, which differ by a constant and the sign.
bool is_displacement_or_dial(const ColumnReading& a, const ColumnReading& b) {
  const auto is_one = [](const ColumnReading& reading) {
    return reading.quantity->name == "axial_displacement" ||
           reading.quantity->name == "dial_reading";
  };
  return is_one(a) && is_one(b);
}

class Questions {
 public:
  explicit Questions(const Proposal& proposal) : p_(proposal) {}

  std::vector<TableQuestion> all() {
    if (p_.structure.heading_lines.empty() && !p_.are_columns_named) {
      ask(About::headings, 0, "headings", "names of the columns by their place: column = 1");
      return std::move(out_);
    }
    for (std::size_t i = 0; i < p_.table.columns.size(); ++i) ask_about_column(i);
    ask_about_gauges();
    ask_about_definitions();
    ask_about_specimen();
    ask_about_pressures();
    return std::move(out_);
  }

 private:
  void ask(About about, std::size_t position, std::string text, std::string remedy) {
    out_.push_back({about, position, std::move(text), std::move(remedy)});
  }

  void ask_about_column(std::size_t i) {
    const TableColumn& column = p_.table.columns[i];
    const ColumnMeaning& meaning = p_.meaning.columns[i];
    if (column.clock && column.clock->is_ambiguous)
      ask(About::date_order, column.position, "order of day and month",
          R"(date_order = "day first" or "month first")");
    const ColumnReading& reading = meaning.reading;
    if (is_unused(reading) || is_auxiliary(reading) || column.clock) return;
    const std::string key = reading.quantity->name;
    if (usual_is_open(reading) && (!varies(i) || is_sign_open(meaning)))
      return ask(About::sign, column.position, "sign of " + column.title,
                 fmt::format("{} = {{ column = {}, sign = -1 }}", key, column.position));
    if (reading.unit_source == UnitSource::asked || is_impossible_strain(i)) {
      ask(About::unit, column.position, "unit of " + column.title,
          fmt::format("{} = {{ column = {}, unit = \"...\" }}", key, column.position));
      return;
    }
    if (meaning.is_decided()) return;
    const ColumnReading& other = *meaning.other;
    if (is_unused(other)) return;
    if (is_sign_open(meaning) || is_definition(reading, other)) return;
    if (is_displacement_or_dial(reading, other) && is_strain_sure()) return;
    ask(About::meaning, column.position, "meaning of " + column.title,
        fmt::format("{} = {{ column = {} }} or {} = ...", key, column.position,
                    other.quantity->name));
  }

  /// A strain beyond 100 % is in a unit that could not be read.
  bool is_impossible_strain(std::size_t i) const {
    constexpr std::array kAtMostWhole{"axial_strain", "radial_strain", "volumetric_strain"};
    const ColumnReading& reading = p_.meaning.columns[i].reading;
    if (std::ranges::find(kAtMostWhole, reading.quantity->name) == kAtMostWhole.end()) return false;
    return std::ranges::any_of(p_.table.columns[i].sample.values,
                               [&](double value) { return std::fabs(value * reading.factor) > 1; });
  }

  bool varies(std::size_t i) const {
    const ColumnSample& sample = p_.table.columns[i].sample;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const double value : sample.values) {
      if (std::isnan(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    constexpr double kDigits = 12;
    return high - low > kDigits * sample.half_unit;
  }

  void ask_about_gauges() {
    for (const GaugeColumn& gauge : find_gauge_columns(p_)) {
      if (gauge.scale) continue;
      const TableColumn& column = p_.table.columns[gauge.column];
      ask(About::unit, column.position,
          (gauge.is_force ? "ring factor of " : "unit of ") + column.heading,
          fmt::format("{} = {{ column = {}, unit = \"{}\", factor = ... }}",
                      gauge.is_force ? "axial_force" : "axial_displacement", column.position,
                      gauge.is_force ? "N" : "mm"));
    }
  }

  bool has_gauge(bool is_force) const {
    return std::ranges::any_of(find_gauge_columns(p_), [is_force](const GaugeColumn& gauge) {
      return gauge.is_force == is_force;
    });
  }

  void ask_about_definitions() {
    const auto is_borrowed = [&](std::string_view name) {
      const ColumnMeaning* found = p_.meaning.of(name);
      return found && found->reading.name == NameMatch::borrowed;
    };
    const bool is_decidable = has("pore_pressure") || has("excess_pore_pressure") ||
                              has("cell_pressure") || has("radial_stress");
    const auto is_undecided = [&](std::string_view name) {
      const ColumnMeaning* found = is_decidable ? p_.meaning.of(name) : nullptr;
      return found && !found->is_decided() && found->other->quantity &&
             is_definition(found->reading, *found->other);
    };
    const bool is_contradicted =
        is_decidable && std::ranges::any_of(p_.meaning.identities, [](const HeldIdentity& held) {
          const auto& names = held.identity->quantities;
          const auto has_name = [&](const char* name) {
            return std::ranges::find(names, name) != names.end();
          };
          return held.identity->is_constant && held.evidence < 0 &&
                 has_name("mean_effective_stress") && has_name("deviator_stress");
        });
    if (is_contradicted || is_borrowed("half_deviator_stress") ||
        is_borrowed("mean_effective_stress_2d") || is_undecided("deviator_stress") ||
        is_undecided("mean_effective_stress"))
      ask(About::definitions, 0, "that these are s' and t",
          "columns half_deviator_stress and mean_effective_stress_2d");
  }

  bool has(std::string_view quantity) const { return p_.has(quantity); }
  bool has_label(std::string_view name) const { return p_.label(name) != nullptr; }

  bool is_volume_needed() const {
    if (has("volumetric_strain") || has("void_ratio")) return false;
    for (std::size_t i = 0; i < p_.meaning.columns.size(); ++i) {
      const ColumnReading& reading = p_.meaning.columns[i].reading;
      if (reading.quantity && is_volume(reading) && varies(i)) return true;
    }
    return false;
  }

  /// A column is the strain, and it is not only known from a displacement without a unit: their
  /// ratio may be that of another height.
  bool is_strain_sure() const {
    const auto is_unsaid = [](const ColumnMeaning* column) {
      return column && column->reading.unit_source == UnitSource::identity;
    };
    const ColumnMeaning* strain = p_.meaning.of("axial_strain");
    return strain && strain->reading.unit_source != UnitSource::asked &&
           !(is_unsaid(strain) && is_unsaid(p_.meaning.of("axial_displacement")));
  }

  void ask_about_specimen() {
    const bool drains = is_volume_needed();
    const bool is_tall =
        has_label("height") || has_label("consolidated_height") || has("specimen_height");
    const bool moves = has("axial_displacement") || has_gauge(false);
    const bool is_raw = moves || has("axial_force") || has_gauge(true);
    if (!is_tall &&
        ((moves && !is_strain_sure()) || (drains && !has("axial_strain")) || has("volume_change")))
      ask(About::value, 0, "height", "--set specimen.height_mm=...");
    const bool is_sized = has("current_area") || has_label("diameter") ||
                          has("specimen_diameter") || has_label("area");
    if (!is_sized && (is_raw || drains))
      ask(About::value, 0, "diameter", "--set specimen.diameter_mm=...");
  }

  bool is_total_stress() const {
    if (p_.type) return p_.type->is_total_stress();
    return is_without_pore_pressure(p_);
  }

  void ask_about_pressures() {
    if (is_total_stress()) return;
    constexpr std::array kEffective{"effective_axial_stress", "effective_radial_stress",
                                    "mean_effective_stress", "mean_effective_stress_2d"};
    const bool effective =
        std::ranges::any_of(kEffective, [&](const char* name) { return has(name); }) ||
        has_label("effective_consolidation_stress");
    const bool cell = has("cell_pressure") || has("radial_stress") || has("axial_stress") ||
                      has("mean_stress") || has_label("cell_pressure");
    const bool pore = has("pore_pressure") || has("back_pressure") || has_label("back_pressure");
    if (effective || (cell && pore)) return;
    if (cell)
      ask(About::value, 0, "back pressure", "pore_pressure or back_pressure = { value = ... }");
    else if (pore)
      ask(About::value, 0, "cell pressure", "cell_pressure = { value = ..., unit = \"kPa\" }");
    else
      ask(About::value, 0, "effective consolidation stress",
          "cell_pressure and back_pressure = { value = ... }");
  }

  const Proposal& p_;
  std::vector<TableQuestion> out_;
};

}  // namespace

bool is_without_pore_pressure(const Proposal& proposal) {
  constexpr std::array kPore{"pore_pressure",
                             "excess_pore_pressure",
                             "back_pressure",
                             "effective_axial_stress",
                             "effective_radial_stress",
                             "mean_effective_stress",
                             "mean_effective_stress_2d",
                             "volume_change",
                             "back_volume",
                             "volumetric_strain",
                             "void_ratio"};
  return std::ranges::none_of(kPore, [&](const char* name) { return proposal.has(name); });
}

std::vector<TableQuestion> find_questions(const Proposal& proposal) {
  return Questions(proposal).all();
}

}  // namespace triax::lab
