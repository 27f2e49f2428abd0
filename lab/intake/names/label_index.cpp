// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/label_index.hpp"

#include <algorithm>
#include <array>
#include <functional>
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
              .also = row.texts("also"),
              .base = row.text("base").value_or("")};
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
  for (Label& label : labels_)
    label.is_base = std::ranges::find(labels_, label.name, &Label::base) != labels_.end();
  read_states(file);
}

void LabelIndex::read_states(const TomlTable& file) {
  constexpr std::array kNames{"initial", "consolidated", "final"};
  for (const TomlTable& row : file.tables("state")) {
    const auto* const name = std::ranges::find(kNames, row.required_text("name"));
    if (name == kNames.end()) row.fail("name", "must be one of: initial, consolidated, final");
    const auto state = static_cast<SpecimenState>(name - kNames.begin());
    const TomlTable phrases = row.required_table("phrases");
    for (const std::string& language : phrases.keys())
      for (const std::string& phrase : phrases.texts(language))
        states_.push_back({heading_tokens(repair_heading(phrase)), state});
  }
  std::ranges::stable_sort(states_, std::ranges::greater(),
                           [](const StatePhrase& phrase) { return phrase.tokens.size(); });
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

std::optional<SpecimenState> LabelIndex::take_state(std::vector<QString>& tokens) const {
  for (const auto& [phrase, state] : states_) {
    const auto found = std::search(tokens.begin(), tokens.end(), phrase.begin(), phrase.end());
    if (found == tokens.end()) continue;
    tokens.erase(found, found + static_cast<std::ptrdiff_t>(phrase.size()));
    return state;
  }
  for (const auto& [phrase, state] : states_)  // without spaces between words
    for (QString& token : tokens) {
      const qsizetype at =
          is_east_asian(phrase.front().front()) ? token.indexOf(phrase.front()) : -1;
      if (at < 0) continue;
      token.remove(at, phrase.front().size());
      if (token.isEmpty()) std::erase(tokens, token);
      return state;
    }
  return std::nullopt;
}

std::optional<SpecimenState> LabelIndex::find_state(const QString& text) const {
  std::vector<QString> tokens = heading_tokens(text);
  const auto state = take_state(tokens);
  return tokens.empty() ? state : std::nullopt;
}

std::vector<const Label*> LabelIndex::in_state(const std::vector<const Label*>& labels,
                                               SpecimenState state) const {
  std::vector<const Label*> out;
  for (const Label* label : labels) {
    const bool is_kept = state == SpecimenState::initial ? label->base.empty() : !label->is_base;
    if (is_kept) out.push_back(label);
    if (state != SpecimenState::consolidated || !label->is_base) continue;
    const auto after = std::ranges::find(labels_, label->name, &Label::base);
    if (std::ranges::find(labels, &*after) == labels.end()) out.push_back(&*after);
  }
  return out;
}

std::vector<const Label*> LabelIndex::find(const QString& name) const {
  std::vector<QString> tokens = heading_tokens(name);
  const auto state = take_state(tokens);
  std::vector<const Label*> found = find_without_state(name);
  if (!state) return found;
  if (!found.empty()) return in_state(found, *state);
  QString rest;
  for (const QString& token : tokens) rest += token + u' ';
  found = find_without_state(rest.trimmed());
  std::erase_if(found, [](const Label* label) { return !label->is_base; });
  return in_state(found, *state);
}

std::vector<const Label*> LabelIndex::find_without_state(const QString& name) const {
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
