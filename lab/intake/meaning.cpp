// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/meaning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace triax::lab {
namespace {

constexpr double kSameUnit = 0.5, kOtherUnit = -2.5;
constexpr std::size_t kBeam = 300;

/// Some columns with a reading each.
struct Assignment {
  double evidence = 0;
  std::vector<int> choice;  ///< of each column, -1 if it has none yet
  std::map<const LexiconQuantity*, std::size_t> column_of;
};

class Search {
 public:
  Search(std::span<const ColumnSample> columns, const SpecimenValues& specimen)
      : columns_(columns), specimen_(specimen) {
    for (const ColumnSample& column : columns) readings_.push_back(find_readings(column));
    for (const Identity& identity : identities()) {
      Needed needed{&identity, {}, {}};
      for (const std::string& name : identity.quantities)
        needed.quantities.push_back(find_lexicon_quantity(name));
      for (const std::string& name : identity.unless)
        needed.unless.push_back(find_lexicon_quantity(name));
      needed_.push_back(std::move(needed));
    }
  }

  Meaning run() {
    std::vector<std::size_t> order(columns_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return readings_[i].size(); });
    std::vector<Assignment> beam{{0, std::vector<int>(columns_.size(), -1), {}}};
    for (const std::size_t column : order) beam = extended(beam, column);
    for (Assignment& one : beam) one.evidence -= superseded(one);
    sort(beam);
    add_neighbours(beam);
    return meaning_of(beam);
  }

 private:
  struct Needed {
    const Identity* identity;
    std::vector<const LexiconQuantity*> quantities, unless;
  };

  std::vector<Assignment> extended(const std::vector<Assignment>& beam, std::size_t column) {
    std::vector<Assignment> out;
    for (const Assignment& one : beam)
      for (std::size_t k = 0; k < readings_[column].size(); ++k) {
        const ColumnReading& reading = readings_[column][k];
        if (is_taken(one, reading)) continue;
        out.push_back(one);
        assign(out.back(), column, k);
      }
    sort(out);
    if (out.size() > kBeam) out.resize(kBeam);
    return out;
  }

  static void sort(std::vector<Assignment>& all) {
    std::ranges::stable_sort(all, std::greater<>(), &Assignment::evidence);
  }

  static bool is_taken(const Assignment& one, const ColumnReading& reading) {
    return reading.quantity && !repeats(*reading.quantity) &&
           one.column_of.contains(reading.quantity);
  }

  void assign(Assignment& one, std::size_t column, std::size_t k) {
    const ColumnReading& reading = readings_[column][k];
    one.evidence += reading.evidence + of_convention(one, column, reading);
    one.choice[column] = static_cast<int>(k);
    if (!reading.quantity) return;
    one.column_of[reading.quantity] = column;
    one.evidence += of_identities(one, reading.quantity);
  }

  /// The beam loses what only the last columns decide. Adds all assignments that differ from the
  /// best one in one column, or in two where the first takes the quantity of the second, and goes
  /// on from a better one.
  void add_neighbours(std::vector<Assignment>& beam) {
    for (bool is_better = true; is_better;) {
      const double best = beam.front().evidence;
      std::vector<Assignment> near = neighbours(beam.front().choice);
      std::ranges::move(near, std::back_inserter(beam));
      sort(beam);
      is_better = beam.front().evidence > best;
    }
  }

  std::vector<Assignment> neighbours(const std::vector<int>& from) {
    std::vector<Assignment> out;
    std::vector<int> choice = from;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      for (std::size_t k = 0; k < readings_[i].size(); ++k) {
        if (static_cast<int>(k) == from[i]) continue;
        choice[i] = static_cast<int>(k);
        const std::size_t holder = holder_of(readings_[i][k], from, i);
        if (holder == columns_.size()) {
          append(choice, out);
          continue;
        }
        for (std::size_t m = 0; m < readings_[holder].size(); ++m) {
          choice[holder] = static_cast<int>(m);
          append(choice, out);
        }
        choice[holder] = from[holder];
      }
      choice[i] = from[i];
    }
    return out;
  }

  /// The other column with the quantity of `reading`; their number if there is none.
  std::size_t holder_of(const ColumnReading& reading, const std::vector<int>& choice,
                        std::size_t column) const {
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (i != column && reading.quantity && !repeats(*reading.quantity) &&
          readings_[i][static_cast<std::size_t>(choice[i])].quantity == reading.quantity)
        return i;
    return columns_.size();
  }

  /// Nothing if a quantity is given twice.
  void append(const std::vector<int>& choice, std::vector<Assignment>& out) {
    Assignment one{0, std::vector<int>(choice.size(), -1), {}};
    for (std::size_t i = 0; i < choice.size(); ++i) {
      const auto k = static_cast<std::size_t>(choice[i]);
      if (is_taken(one, readings_[i][k])) return;
      assign(one, i, k);
    }
    one.evidence -= superseded(one);
    out.push_back(std::move(one));
  }

  static bool repeats(const LexiconQuantity& quantity) {
    return quantity.dimension == "text" || quantity.dimension == "any";
  }

  const ColumnReading& reading(const Assignment& one, std::size_t column) const {
    return readings_[column][static_cast<std::size_t>(one.choice[column])];
  }

  /// Stresses and the axial strain of one file have one convention: tension positive is one unusual
  /// choice, not one of each column, and compression positive is unusual beside it.
  struct Signs {
    int tension = 0, compression = 0;
    void add(const ColumnReading& one) {
      constexpr std::array kOther{"deviator_stress",      "half_deviator_stress", "pore_pressure",
                                  "excess_pore_pressure", "back_pressure",        "cell_pressure"};
      const std::string& name = one.quantity->name;
      if (name != "axial_strain" && (one.quantity->dimension != "pressure" ||
                                     std::ranges::find(kOther, name) != kOther.end()))
        return;
      ++(one.sign < 0 ? tension : compression);
    }
    double correction() const {
      return tension == 0 ? 0 : kOtherSign * (1 + compression - tension);
    }
  };

  /// Units that are not stated are those of other columns; an unusual sign is one of many columns.
  double of_convention(const Assignment& one, std::size_t column, const ColumnReading& now) const {
    if (!now.quantity) return 0;
    double out = 0;
    Signs signs;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (i == column || one.choice[i] < 0) continue;
      const ColumnReading& before = reading(one, i);
      if (!before.quantity) continue;
      signs.add(before);
      const bool is_unsaid =
          now.unit_source == UnitSource::identity || before.unit_source == UnitSource::identity;
      if (is_unsaid && unit_group(*now.quantity) == unit_group(*before.quantity))
        out += now.factor == before.factor ? kSameUnit : kOtherUnit;
    }
    const double before = signs.correction();
    signs.add(now);
    return out + signs.correction() - before;
  }

  double of_identities(const Assignment& one, const LexiconQuantity* added) {
    double out = 0;
    for (const Needed& needed : needed_)
      if (is_one_of(needed.quantities, added) && is_known(one, needed))
        out += evidence(one, needed);
    return out;
  }
  static bool is_one_of(const std::vector<const LexiconQuantity*>& all,
                        const LexiconQuantity* one) {
    return std::ranges::find(all, one) != all.end();
  }
  static bool is_known(const Assignment& one, const Needed& needed) {
    return std::ranges::all_of(
        needed.quantities, [&](const auto* quantity) { return one.column_of.contains(quantity); });
  }

  /// Evidence of identities for which a stronger one is known.
  double superseded(const Assignment& one) {
    double out = 0;
    for (const Needed& needed : needed_)
      if (is_superseded(one, needed) && is_known(one, needed)) out += evidence(one, needed);
    return out;
  }
  static bool is_superseded(const Assignment& one, const Needed& needed) {
    return std::ranges::any_of(
        needed.unless, [&](const auto* quantity) { return one.column_of.contains(quantity); });
  }

  double evidence(const Assignment& one, const Needed& needed) {
    std::vector<double> key{static_cast<double>(needed.identity - identities().data())};
    for (const auto* quantity : needed.quantities) {
      const std::size_t column = one.column_of.at(quantity);
      key.push_back(static_cast<double>(column));
      key.push_back(reading(one, column).factor * reading(one, column).sign);
    }
    const auto known = cache_.find(key);
    if (known != cache_.end()) return known->second;
    std::vector<const Series*> series;
    for (const auto* quantity : needed.quantities)
      series.push_back(&series_of(one.column_of.at(quantity), one));
    const double found = needed.identity->evidence(*needed.identity, series, specimen_);
    return cache_[key] = std::isfinite(found) ? found : 0;
  }

  const Series& series_of(std::size_t column, const Assignment& one) {
    const ColumnReading& as = reading(one, column);
    const auto key = std::pair(column, as.factor * as.sign);
    const auto [at, is_new] = series_.try_emplace(key);
    if (!is_new) return at->second;
    at->second.half_unit = columns_[column].half_unit * std::fabs(as.factor);
    for (const double value : columns_[column].values)
      at->second.values.push_back(as.sign * (value * as.factor + as.offset));
    return at->second;
  }

  Meaning meaning_of(const std::vector<Assignment>& beam) {
    Meaning out;
    const Assignment& best = beam.front();
    for (std::size_t i = 0; i < columns_.size(); ++i)
      out.columns.push_back({reading(best, i), {}, 0});
    for (const Assignment& one : beam)
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        ColumnMeaning& column = out.columns[i];
        const ColumnReading& now = reading(one, i);
        if (now.quantity == column.reading.quantity && now.factor != column.reading.factor)
          column.unit_lead = std::min(column.unit_lead, best.evidence - one.evidence);
        if (column.other || column.reading.same_meaning(reading(one, i))) continue;
        column.other = reading(one, i);
        column.lead = best.evidence - one.evidence;
      }
    for (const Needed& needed : needed_)
      if (is_known(best, needed) && !is_superseded(best, needed))
        if (const double found = evidence(best, needed); found != 0)
          out.identities.push_back({needed.identity, found});
    for (ColumnMeaning& column : out.columns) settle_unit(column, out);
    return out;
  }

  /// A unit that nothing decides is asked: that of a time, if no other time of the file has one.
  static void settle_unit(ColumnMeaning& column, const Meaning& meaning) {
    ColumnReading& reading = column.reading;
    if (!reading.quantity || reading.unit_source != UnitSource::identity) return;
    const bool is_unknown_time =
        reading.quantity->dimension == "time" &&
        std::ranges::none_of(meaning.columns, [](const ColumnMeaning& other) {
          const auto& [quantity, source] =
              std::pair(other.reading.quantity, other.reading.unit_source);
          return quantity && quantity->dimension == "time" &&
                 (source == UnitSource::heading || source == UnitSource::row);
        });
    if (is_unknown_time || column.unit_lead < ColumnMeaning::kDecided)
      reading.unit_source = UnitSource::asked;
  }

  std::span<const ColumnSample> columns_;
  const SpecimenValues& specimen_;
  std::vector<std::vector<ColumnReading>> readings_;
  std::vector<Needed> needed_;
  std::map<std::vector<double>, double> cache_;
  std::map<std::pair<std::size_t, double>, Series> series_;
};

}  // namespace

const ColumnMeaning* Meaning::of(std::string_view quantity) const {
  for (const ColumnMeaning& column : columns)
    if (column.reading.quantity && column.reading.quantity->name == quantity) return &column;
  return nullptr;
}

Meaning find_meaning(std::span<const ColumnSample> columns, const SpecimenValues& specimen) {
  if (columns.empty()) return {};
  return Search(columns, specimen).run();
}

}  // namespace triax::lab
