// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QHash>
#include <QString>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/base/toml_reader.hpp"
#include "lab/intake/names/unit_names.hpp"

namespace triax::lab {

/// A value that laboratories write above a table, from lab/intake/lexicon/labels.toml.
struct Label {
  std::string name;
  std::string metadata;  ///< key of triax, or empty
  std::string dimension;
  std::vector<std::string> also;                   ///< other dimensions that the value can have
  const UnitName* unit = nullptr;                  ///< canonical; null for texts and clocks
  std::optional<std::pair<double, double>> usual;  ///< in the canonical unit
  int quantity = -1;     ///< position in lexicon_quantities(): its names count as well
  std::string base;      ///< label of the specimen as built; empty: not a value after consolidation
  bool is_base = false;  ///< of another label

  bool is_number() const { return unit != nullptr; }
  /// Without units, any label fits.
  bool fits(const std::vector<const UnitName*>& units) const;
};

/// Of the specimen, in which a value was measured; `final` is any later or other one.
enum class SpecimenState { initial, consolidated, final };

/// Labels by their names.
class LabelIndex {
 public:
  /// Reads the labels at the first call.
  static const LabelIndex& get();
  /// Labels that a text of repair_heading(), without its unit, names: as a whole, or by its
  /// beginning in front of a symbol or a second name ("Initial height H0"). A phrase of a state in
  /// it counts as in_state() does.
  std::vector<const Label*> find(const QString& name) const;
  /// The labels that `labels` are in a state of the specimen: "height" is "consolidated_height".
  /// Values that the state changes are left out if no label has them.
  std::vector<const Label*> in_state(const std::vector<const Label*>& labels,
                                     SpecimenState state) const;
  /// The state that a text of repair_heading() names and nothing else ("After consolidation:").
  std::optional<SpecimenState> find_state(const QString& text) const;

 private:
  struct StatePhrase {
    std::vector<QString> tokens;
    SpecimenState state{};
  };

  LabelIndex();
  void read_states(const TomlTable& file);
  std::vector<const Label*> find_exact(const QString& name) const;
  std::vector<const Label*> find_without_state(const QString& name) const;
  /// Removes the longest phrase of a state.
  std::optional<SpecimenState> take_state(std::vector<QString>& tokens) const;

  std::vector<Label> labels_;
  std::vector<StatePhrase> states_;  ///< the longest first
  QHash<QString, std::vector<std::size_t>> by_key_;
};

}  // namespace triax::lab
