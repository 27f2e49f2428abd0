// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QHash>
#include <QString>
#include <string>
#include <vector>

#include "lab/intake/names/composed_names.hpp"
#include "lab/intake/names/phrase_table.hpp"
#include "lab/intake/names/unit_names.hpp"

namespace triax::lab {

/// Names of all quantities in the form in which headings are compared.
class NameIndex {
 public:
  /// Reads the lexicon at the first call.
  static const NameIndex& get();

  /// Quantities that a whole heading (of repair_heading()) names: listed, as a symbol, or else made
  /// of known words.
  QuantitySet find_exact(const QString& repaired) const;
  /// Phrases inside a heading, with positions in lexicon_quantities().
  const PhraseTable& phrases() const { return phrases_; }
  const ComposedNames& composed() const { return composed_; }
  /// Quantities for which laboratories use a name of one of `lenders`, directly or through another.
  QuantitySet find_borrowers(const QuantitySet& lenders) const;

 private:
  NameIndex();

  QHash<QString, QuantitySet> exact_;
  ComposedNames composed_;
  PhraseTable phrases_;
  std::vector<QuantitySet> borrowers_;
};

/// Quantities that can have one of these units; all for no unit.
QuantitySet find_fitting(const std::vector<const UnitName*>& units);

}  // namespace triax::lab
