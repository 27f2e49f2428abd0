// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QHash>
#include <QString>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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
  int quantity = -1;  ///< position in lexicon_quantities(): its names count as well

  bool is_number() const { return unit != nullptr; }
  /// Without units, any label fits.
  bool fits(const std::vector<const UnitName*>& units) const;
};

/// Labels by their names.
class LabelIndex {
 public:
  /// Reads the labels at the first call.
  static const LabelIndex& get();
  /// Labels that a text of repair_heading(), without its unit, names: as a whole, or by its
  /// beginning in front of a symbol or a second name ("Initial height H0").
  std::vector<const Label*> find(const QString& name) const;

 private:
  LabelIndex();
  std::vector<const Label*> find_exact(const QString& name) const;

  std::vector<Label> labels_;
  QHash<QString, std::vector<std::size_t>> by_key_;
};

}  // namespace triax::lab
