// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/name_index.hpp"

#include <stdexcept>

#include "lab/intake/names/heading_form.hpp"
#include "lab/intake/names/lexicon_file.hpp"
#include "lab/intake/names/lexicon_quantity.hpp"
#include "lab/intake/names/symbol_form.hpp"

namespace triax::lab {
namespace {

/// Row i: the quantities that use the names of quantity i, directly or through another.
std::vector<QuantitySet> read_borrowers() {
  const auto& quantities = lexicon_quantities();
  std::vector<QuantitySet> borrowers(quantities.size());
  for (std::size_t i = 0; i < quantities.size(); ++i)
    for (const SharedName& shared : quantities[i].shared_names)
      for (std::size_t lender = 0; lender < quantities.size(); ++lender)
        if (shared.names.empty() && shared.quantity == quantities[lender].name)
          borrowers[lender].set(i);
  for (std::size_t through = 0; through < quantities.size(); ++through)
    for (QuantitySet& row : borrowers)
      if (row[through]) row |= borrowers[through];
  return borrowers;
}

}  // namespace

NameIndex::NameIndex() : borrowers_(read_borrowers()) {
  const auto& files = lexicon_quantity_files();
  if (files.size() > QuantitySet().size()) throw std::length_error("too many quantities");
  for (std::size_t i = 0; i < files.size(); ++i)
    for (const TomlTable& block : files[i].tables("names")) {
      for (const std::string& name : block.texts("exact"))
        for (const QString& key : name_keys(name)) exact_[key].set(i);
      for (const std::string& phrase : block.texts("words"))
        phrases_.add(heading_tokens(repair_heading(phrase)), static_cast<int>(i));
    }
}

const NameIndex& NameIndex::get() {
  static const NameIndex index;
  return index;
}

QuantitySet NameIndex::find_exact(const QString& repaired) const {
  QuantitySet found = exact_.value(heading_key(repaired));
  for (const QString& reading : symbol_readings(repaired)) found |= exact_.value(reading);
  return found.any() ? found : composed_.find(heading_tokens(repaired));
}

QuantitySet NameIndex::find_borrowers(const QuantitySet& lenders) const {
  QuantitySet found;
  for (std::size_t i = 0; i < borrowers_.size(); ++i)
    if (lenders[i]) found |= borrowers_[i];
  return found & ~lenders;
}

QuantitySet find_fitting(const std::vector<const UnitName*>& units) {
  if (units.empty()) return ~QuantitySet();
  QuantitySet fitting;
  const auto& quantities = lexicon_quantities();
  const bool is_plain = std::ranges::any_of(
      units, [](const UnitName* unit) { return unit->name == "-"; });  // also below a date
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (is_plain && quantities[i].dimension == "clock") fitting.set(i);
    for (const UnitName* unit : units)
      if (quantities[i].can_have(unit->dimension)) fitting.set(i);
  }
  return fitting;
}

}  // namespace triax::lab
