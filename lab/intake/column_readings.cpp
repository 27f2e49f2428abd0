// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/column_readings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "lab/intake/names/heading_form.hpp"
#include "lab/intake/names/symbol_form.hpp"

namespace triax::lab {
namespace {

/// Evidence of the way in which a heading names a quantity.
double evidence_of(NameMatch how) {
  switch (how) {
    case NameMatch::exact:
      return 0;
    case NameMatch::kept_word:
    case NameMatch::dropped:
      return -0.5;
    case NameMatch::tail:
    case NameMatch::symbol:
      return -1;
    case NameMatch::head:
      return -2;
    case NameMatch::words:
      return -3;
    case NameMatch::borrowed:
      return -2.5;
  }
  return 0;
}

constexpr double kUnused = -7;             ///< a column that has a name, but is not used
constexpr double kUnusedUnnamed = -2;      ///< a column without a name needs readings that prove it
constexpr double kOpenSign = -0.3;         ///< the less usual of two usual signs
constexpr double kAgainstSoftware = -1.5;  ///< against the sign of the software: readings decide
constexpr std::size_t kMaxReadings = 24;
constexpr double kFarBehind = 9;

/// Units that files leave out, by dimension, with their evidence.
struct UnsaidUnit {
  const char *dimension, *unit;
  double evidence;
};
constexpr auto kUnsaid = std::to_array<UnsaidUnit>({
    {"pressure", "kPa", 0},
    {"pressure", "MPa", -2},
    {"pressure", "psi", -2},
    {"pressure", "kgf/cm2", -2},
    {"pressure", "bar", -2},
    {"length", "mm", -1.5},
    {"length", "in", -3.5},
    {"length", "cm", -3.5},
    {"length", "0.01 mm", -3.5},
    {"area", "mm2", 0},
    {"area", "cm2", 0},
    {"area", "in2", -2},
    {"volume", "mm3", -1.5},
    {"volume", "cm3", -1.5},
    {"force", "kN", 0},
    {"force", "N", 0},
    {"force", "kgf", -1},
    {"force", "lbf", -1},
    {"time", "s", 0},
    {"time", "min", 0},
    {"time", "h", 0},
    {"strain", "%", 0},
    {"strain", "-", -0.1},
});

constexpr std::array kStrains{"axial_strain", "radial_strain", "volumetric_strain", "shear_strain"};
constexpr std::array kSigned{"axial_displacement", "axial_strain",         "volumetric_strain",
                             "volume_change",      "back_volume",          "axial_force",
                             "deviator_stress",    "half_deviator_stress", "radial_strain",
                             "cell_volume"};
/// Quantities that a column without a known name can be, if its unit allows it.
constexpr std::array kUnnamedQuantities{"axial_force",
                                        "axial_displacement",
                                        "cell_pressure",
                                        "pore_pressure",
                                        "deviator_stress",
                                        "mean_effective_stress",
                                        "mean_effective_stress_2d",
                                        "half_deviator_stress",
                                        "effective_radial_stress",
                                        "effective_axial_stress",
                                        "axial_stress",
                                        "mean_stress",
                                        "volume_change",
                                        "current_area",
                                        "specimen_height",
                                        "excess_pore_pressure",
                                        "back_pressure",
                                        "axial_strain",
                                        "volumetric_strain",
                                        "radial_strain",
                                        "time"};

bool is_name_in(const auto& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

/// Evidence of a quantity that only the unit of a column shows. Few quantities are lengths, many
/// are pressures.
double evidence_of_unit(const LexiconQuantity& quantity) {
  constexpr std::array kOfFew{"axial_force", "axial_displacement", "specimen_height",
                              "current_area", "time"};
  return is_name_in(kOfFew, quantity.name) ? -2 : -5;
}

/// True if a hint about the sign is for this heading.
bool names_heading(const SignHint& hint, const std::string& heading) {
  const QString key = heading_key(repair_heading(heading));
  return std::ranges::any_of(hint.names, [&](const std::string& name) {
    const auto keys = name_keys(name);
    return std::ranges::find(keys, key) != keys.end();
  });
}

std::optional<int> usual_sign(const LexiconQuantity& quantity, const std::string& heading) {
  std::optional<int> of_all;
  for (const SignHint& hint : quantity.sign_hints) {
    if (!hint.sign) continue;
    if (hint.names.empty()) {
      if (!of_all) of_all = hint.sign;
    } else if (names_heading(hint, heading)) {
      return hint.sign;
    }
  }
  return of_all;
}

/// The readings that one column can have.
class Readings {
 public:
  explicit Readings(const ColumnSample& column) : column_(column) {
    const HeadingNames names = best_names();
    heading_ = names.name;
    const bool from_row = !find_unit_names(column.unit_of_row).empty();
    unit_ = from_row ? column.unit_of_row : names.unit;
    source_ = from_row ? UnitSource::row : UnitSource::heading;
    double rank = 0;
    constexpr double kPerRank = -0.2;
    for (const NameCandidate& one : names.candidates) {
      add(*one.quantity, one.how, evidence_of_name(one, names) + rank);
      rank += kPerRank;
    }
    if (!names.candidates.empty()) add_parts(names);
    if (all_.empty()) add_unnamed();
    std::ranges::stable_sort(all_, std::greater<>(), &ColumnReading::evidence);
    const double best = all_.empty() ? 0 : all_.front().evidence;
    std::erase_if(all_, [&](const ColumnReading& one) { return one.evidence < best - kFarBehind; });
    if (all_.size() > kMaxReadings) all_.resize(kMaxReadings);
    const bool is_named = !all_.empty() && all_.front().name;
    all_.push_back({.evidence = all_.empty() ? 0 : is_named ? best + kUnused : kUnusedUnnamed});
  }
  std::vector<ColumnReading> take() { return std::move(all_); }

 private:
  /// The names of the whole heading, or of its lowest line if that is known better. Lines above
  /// are names of groups of columns.
  HeadingNames best_names() const {
    HeadingNames best;
    for (const std::string& text : column_.headings) {
      HeadingNames found = find_names(text, column_.unit_of_row);
      const bool is_better =
          best.candidates.empty() ||
          (!found.candidates.empty() &&
           evidence_of(found.candidates.front().how) > evidence_of(best.candidates.front().how));
      if (!found.candidates.empty() && is_better) {
        if (found.unit.empty()) found.unit = best.unit;
        best = std::move(found);
      } else if (best.unit.empty()) {
        best.unit = found.unit;
      }
    }
    return best;
  }

  /// Symbols lose the mark of effective stresses.
  static double evidence_of_name(const NameCandidate& one, const HeadingNames& names) {
    if (one.how != NameMatch::borrowed) return evidence_of(one.how);
    constexpr double kLostMark = -1.2;
    const bool is_effective = one.quantity->name.find("effective") != std::string::npos;
    const bool is_symbol = !symbol_readings(repair_heading(names.name)).empty();
    return evidence_of(one.lender) + (is_effective && is_symbol ? kLostMark : evidence_of(one.how));
  }

  /// Other quantities of the lowest of several lines of headings: "Stufe" below "Zeit".
  void add_parts(const HeadingNames& whole) {
    constexpr double kOfPart = -0.2, kMinEvidence = -1;
    if (column_.headings.size() < 2) return;
    for (const NameCandidate& one :
         find_names(column_.headings[1], column_.unit_of_row).candidates) {
      const bool is_known = std::ranges::find(whole.candidates, one.quantity,
                                              &NameCandidate::quantity) != whole.candidates.end();
      if (evidence_of(one.how) > kMinEvidence && !is_known)
        add(*one.quantity, one.how, evidence_of(one.how) + kOfPart);
    }
  }

  void add_unnamed() {
    const bool has_heading = std::ranges::any_of(
        column_.headings, [](const std::string& text) { return !text.empty(); });
    if (!has_heading && column_.is_number)
      if (const auto* number = find_lexicon_quantity("reading_number")) add(*number, {}, -1);
    if (unit_.empty()) return;
    for (const char* name : kUnnamedQuantities)
      if (const auto* quantity = find_lexicon_quantity(name))
        if (quantity->dimension != "none" || is_name_in(kStrains, name))
          add(*quantity, {}, evidence_of_unit(*quantity));
  }

  void add(const LexiconQuantity& quantity, std::optional<NameMatch> how, double evidence) {
    const bool is_text = quantity.dimension == "text" || quantity.dimension == "any" ||
                         quantity.dimension == "clock";
    if (quantity.dimension == "clock" && column_.is_number) return;  // these are no dates
    if (is_text || !column_.is_number) {
      constexpr double kTimeInWords = -2;  // unless the cells are clocks, which is found later
      const bool is_time = quantity.dimension == "time";
      if (is_text || is_time || quantity.name == "stage")
        all_.push_back({&quantity, "", 1, 0, 1, UnitSource::name, how,
                        evidence + (is_time ? kTimeInWords : 0)});
      return;
    }
    if (unit_.empty()) return add_unsaid(quantity, how, evidence);
    for (const UnitName* unit : find_unit_names(unit_))
      if (const auto conversion = conversion_to_canonical(quantity, *unit))
        add_signs(
            {&quantity, unit_, conversion->factor, conversion->offset, 1, source_, how, evidence});
    constexpr double kPlainNumber = -1;  // a void ratio below "%": its size decides
    const bool is_ratio = quantity.dimension == "none" && !is_name_in(kStrains, quantity.name);
    if (is_ratio && !all_.empty() && all_.back().quantity == &quantity && all_.back().factor != 1)
      add_signs({&quantity, "", 1, 0, 1, UnitSource::identity, how, evidence + kPlainNumber});
  }

  void add_unsaid(const LexiconQuantity& quantity, std::optional<NameMatch> how, double evidence) {
    bool any = false;
    for (const UnsaidUnit& unsaid : kUnsaid) {
      if (unsaid.dimension != unit_group(quantity)) continue;
      for (const UnitName* unit : find_unit_names(std::string_view(unsaid.unit)))
        if (const auto factor = factor_to_canonical(quantity, *unit)) {
          any = true;
          add_signs({&quantity, unsaid.unit, *factor, 0, 1, UnitSource::identity, how,
                     evidence + unsaid.evidence});
          break;
        }
    }
    if (any) return;
    const bool counts = is_name_in(std::array{"stage", "cycle", "reading_number"}, quantity.name);
    add_signs(
        {&quantity, "", 1, 0, 1, counts ? UnitSource::name : UnitSource::none, how, evidence});
  }

  void add_signs(ColumnReading reading) {
    const LexiconQuantity& quantity = *reading.quantity;
    const auto& of_software = column_.software_sign;
    const auto usual = of_software ? of_software : usual_sign(quantity, heading_);
    const double evidence = reading.evidence;
    const bool can_be_negative =
        is_name_in(kSigned, quantity.name) || quantity.dimension == "pressure";
    for (const int sign : {1, -1}) {
      double of_sign = 0;
      if (usual.value_or(1) == 0)
        of_sign = sign == 1 ? 0 : kOpenSign;
      else if (sign != usual.value_or(1))
        of_sign = of_software ? kAgainstSoftware : kOtherSign;
      if (sign == -1 && !can_be_negative && usual.value_or(1) == 1) continue;
      reading.sign = sign;
      reading.evidence = evidence + of_sign + of_range(reading);
      all_.push_back(reading);
    }
  }

  /// Against values outside the usual range.
  double of_range(const ColumnReading& reading) const {
    constexpr double kMaxLoss = 6, kSteep = 100;
    const auto& usual = reading.quantity->usual;
    if (!usual) return 0;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const double value : column_.values) {
      if (std::isnan(value)) continue;
      const double converted = reading.sign * (value * reading.factor + reading.offset);
      low = std::min(low, converted);
      high = std::max(high, converted);
    }
    if (low > high || (low >= usual->first && high <= usual->second)) return 0;
    // For a quantity that is never 0 the factor counts, which may be that of another unit.
    const bool is_positive = usual->first > 0 && low > 0;
    const double outside =
        is_positive ? std::max(std::log(usual->first / low), std::log(high / usual->second))
                    : kSteep * std::max(usual->first - low, high - usual->second) /
                          (usual->second - usual->first);
    return -std::min(kMaxLoss, is_positive ? 3 * outside : 2 * std::log(1 + outside));
  }

  const ColumnSample& column_;
  std::string heading_, unit_;
  UnitSource source_ = UnitSource::heading;
  std::vector<ColumnReading> all_;
};

}  // namespace

bool ColumnReading::same_meaning(const ColumnReading& other) const {
  const auto is_pressure_on_side = [](const ColumnReading& one) {
    return one.quantity &&
           (one.quantity->name == "cell_pressure" || one.quantity->name == "radial_stress");
  };
  return factor == other.factor && sign == other.sign &&
         (quantity == other.quantity || (is_pressure_on_side(*this) && is_pressure_on_side(other)));
}

std::string_view unit_group(const LexiconQuantity& quantity) {
  return is_name_in(kStrains, quantity.name) ? std::string_view("strain")
                                             : std::string_view(quantity.dimension);
}

std::vector<std::string> unsaid_units(const LexiconQuantity& quantity) {
  std::vector<std::string> out;
  for (const UnsaidUnit& one : kUnsaid)
    if (one.dimension == unit_group(quantity)) out.emplace_back(one.unit);
  return out;
}

std::vector<ColumnReading> find_readings(const ColumnSample& column) {
  return Readings(column).take();
}

}  // namespace triax::lab
