// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/label_index.hpp"

#include <algorithm>
#include <iterator>

#include "lab/intake/names/heading_form.hpp"
#include "lab/intake/names/lexicon_file.hpp"
#include "lab/intake/names/lexicon_quantity.hpp"
#include "lab/intake/names/name_index.hpp"
#include "lab/intake/names/symbol_form.hpp"

namespace triax::lab {
namespace {

const UnitName* canonical_unit(const std::string& dimension, const std::string& unit) {
  for (const UnitName* found : find_unit_names(unit))
    if (found->dimension == dimension) return found;
  return nullptr;
}

Label read_label(const TomlTable& row) {
  Label label{.name = row.required_text("name"),
              .metadata = row.text("metadata").value_or(""),
              .dimension = row.required_text("dimension"),
              .also = row.texts("also")};
  label.unit = canonical_unit(label.dimension, row.text("unit").value_or("-"));
  if (const auto usual = row.numbers("usual"); usual.size() == 2)
    label.usual = {usual[0], usual[1]};
  if (const auto* quantity = find_lexicon_quantity(row.text("of").value_or("")))
    label.quantity = static_cast<int>(quantity - lexicon_quantities().data());
  return label;
}

}  // namespace

bool Label::fits(const std::vector<const UnitName*>& units) const {
  return units.empty() || std::ranges::any_of(units, [&](const UnitName* other) {
           return other->dimension == dimension ||
                  std::ranges::find(also, other->dimension) != also.end();
         });
}

LabelIndex::LabelIndex() {
  const TomlTable file = read_lexicon_file("labels");
  for (const TomlTable& row : file.tables("label")) {
    const TomlTable names = row.required_table("names");
    for (const std::string& language : names.keys())
      for (const std::string& name : names.texts(language))
        for (const QString& key : name_keys(name)) by_key_[key].push_back(labels_.size());
    labels_.push_back(read_label(row));
  }
}

const LabelIndex& LabelIndex::get() {
  static const LabelIndex index;
  return index;
}

std::vector<const Label*> LabelIndex::find_exact(const QString& name) const {
  std::vector<QString> keys = symbol_readings(name);
  keys.push_back(heading_key(name));
  std::vector<const Label*> found;
  const QuantitySet quantities = NameIndex::get().find_exact(name);
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    const Label& label = labels_[i];
    const bool is_named = std::ranges::any_of(keys, [&](const QString& key) {
      const auto owners = by_key_.value(key);
      return std::ranges::find(owners, i) != owners.end();
    });
    if (is_named || (label.quantity >= 0 && quantities[static_cast<std::size_t>(label.quantity)]))
      found.push_back(&label);
  }
  return found;
}

std::vector<const Label*> LabelIndex::find(const QString& name) const {
  std::vector<const Label*> found = find_exact(name);
  for (qsizetype at = 1; found.empty() && at < name.size(); ++at) {
    const bool ends_script = is_east_asian(name[at - 1]) && !is_east_asian(name[at]);
    if (!is_heading_blank(name[at]) && name[at] != u'(' && !ends_script) continue;
    found = find_exact(name.first(at));
    if (found.empty()) continue;
    const QString rest = without_outer(name.sliced(at), u" _()[],");
    const auto of_rest = find_exact(rest);
    std::vector<const Label*> both;
    std::ranges::copy_if(found, std::back_inserter(both), [&](const Label* label) {
      return std::ranges::find(of_rest, label) != of_rest.end();
    });
    const bool is_symbol = !rest.isEmpty() && rest.front().isLetter() &&
                           std::ranges::none_of(rest, is_heading_blank) &&
                           !symbol_readings(rest).empty();
    if (!both.empty() || !is_symbol) found = std::move(both);
  }
  return found;
}

}  // namespace triax::lab
