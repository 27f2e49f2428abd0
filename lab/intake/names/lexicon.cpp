// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/lexicon.hpp"

#include <QRegularExpression>
#include <QSet>
#include <algorithm>
#include <map>
#include <utility>

#include "lab/intake/names/heading_form.hpp"
#include "lab/intake/names/heading_unit.hpp"
#include "lab/intake/names/lexicon_file.hpp"
#include "lab/intake/names/name_index.hpp"
#include "lab/intake/names/symbol_form.hpp"

namespace triax::lab {
namespace {

/// Sections 5, 6 and 8 of normalise.toml.
struct SearchRules {
  std::vector<QRegularExpression> drops;
  std::vector<QRegularExpression> statistics;  ///< those of `drops` that a logger appends
  PhraseTable kept_words;
  QSet<QString> group_names;
  QSet<QString> of_words;
};

QString joined_with_blanks(const std::vector<QString>& tokens) {
  QString text;
  for (const QString& token : tokens) text += token + u' ';
  return text;
}

std::vector<QString> tokens_of(const std::string& utf8) {
  return heading_tokens(repair_heading(utf8));
}

int position_of(const LexiconQuantity& quantity) {
  return static_cast<int>(&quantity - lexicon_quantities().data());
}

SearchRules read_search_rules() {
  const TomlTable file = read_lexicon_file("normalise");
  SearchRules rules;
  for (const TomlTable& row : file.tables("drop")) {
    const QRegularExpression pattern(
        QString::fromStdString(row.required_text("pattern")),
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
    rules.drops.push_back(pattern);
    if (row.required_text("kind") == "statistic") rules.statistics.push_back(pattern);
  }
  for (const TomlTable& row : file.tables("keep"))
    if (const auto* quantity = find_lexicon_quantity(row.text("quantity").value_or("")))
      for (const std::string& word : row.texts("words"))
        rules.kept_words.add(tokens_of(word), position_of(*quantity));
  for (const std::string& name : file.required_table("lookup").texts("group_names"))
    rules.group_names.insert(joined_with_blanks(tokens_of(name)));
  for (const std::string& word : file.required_table("lookup").texts("of_words"))
    rules.of_words.insert(QString::fromStdString(word));
  return rules;
}

const SearchRules& search_rules() {
  static const SearchRules rules = read_search_rules();
  return rules;
}

/// Quantities that one rule of the search finds.
struct SearchLevel {
  NameMatch how = NameMatch::exact;
  QuantitySet found;
  NameMatch lender = NameMatch::exact;
};
using SearchLevels = std::vector<SearchLevel>;

bool has_ignored(const QuantitySet& found) {
  const auto* ignored = find_lexicon_quantity("ignored");
  return ignored && found[static_cast<std::size_t>(position_of(*ignored))];
}

/// Quantities of words that say that a heading is no reading of what the rest names.
QuantitySet find_kept_words(QString text) {
  for (const QRegularExpression& statistic : search_rules().statistics) text.remove(statistic);
  QuantitySet found;
  const auto tokens = heading_tokens(text);
  for (const auto& match : search_rules().kept_words.find(tokens))
    found.set(static_cast<std::size_t>(match.number));
  const auto* ignored = find_lexicon_quantity("ignored");
  if (ignored && NameIndex::get().composed().is_no_reading(tokens))
    found.set(static_cast<std::size_t>(position_of(*ignored)));
  return found;
}

/// The heading without one, then without two of the parts that may be missing.
std::vector<QString> find_shorter_forms(const QString& text) {
  std::vector<QString> forms{text};
  std::size_t first = 0;
  for (int round = 0; round < 2; ++round) {
    const std::size_t end = forms.size();
    for (; first < end; ++first)
      for (const QRegularExpression& drop : search_rules().drops) {
        QString form = forms[first];
        form = without_outer(form.remove(drop), u" _");
        if (std::ranges::find(forms, form) == forms.end() && !heading_key(form).isEmpty())
          forms.push_back(std::move(form));
      }
  }
  forms.erase(forms.begin());
  return forms;
}

void append_shorter_forms(const QString& text, SearchLevels& levels) {
  SearchLevels dropped;
  bool has_kept_word = false;
  for (const QString& form : find_shorter_forms(text)) {
    const QuantitySet found = NameIndex::get().find_exact(form);
    dropped.push_back({NameMatch::dropped, found});
    has_kept_word = has_kept_word || (found.any() && find_kept_words(form).any());
    if (found.any()) break;  // "Ch3 σ1" is σ1, not σ
  }
  if (!has_kept_word) levels.push_back({NameMatch::kept_word, find_kept_words(text)});
  levels.insert(levels.end(), dropped.begin(), dropped.end());
}

/// Places at which a heading can be split in two: {end of the head, begin of the tail}.
std::vector<std::pair<qsizetype, qsizetype>> find_splits(const QString& text) {
  std::vector<std::pair<qsizetype, qsizetype>> splits;
  for (qsizetype i = 0; i < text.size();) {
    const qsizetype start = i;
    while (i < text.size() && is_heading_blank(text[i])) ++i;
    const bool ends_script =
        start > 0 && is_east_asian(text[start - 1]) && !is_east_asian(text[start]);
    if (i > start || ends_script) splits.emplace_back(start, i);
    if (i == start) ++i;
  }
  return splits;
}

bool has_symbol_character(const QString& text) {
  constexpr QStringView kSymbolCharacters = u"'σεγτηδΔ";
  return std::ranges::any_of(text, [&](QChar c) { return kSymbolCharacters.contains(c); });
}

/// "Δu", "(σ1-σ3)m", but not "ε", which may be any strain.
bool is_symbol_with_index(const QString& text) {
  return has_symbol_character(text) && without_outer(text, u"()[]").size() > 1;
}

/// "of reading" belongs to the name before it and is no name of its own.
bool begins_with_of(const QString& text) {
  const auto tokens = heading_tokens(text);
  return !tokens.empty() && search_rules().of_words.contains(tokens.front());
}

/// Names and symbols at the end of a heading. Quantities that its beginning names, too, come first:
/// true if there are some.
bool append_tails(const QString& text, const QuantitySet& contradicted, SearchLevels& levels) {
  const NameIndex& index = NameIndex::get();
  QuantitySet both, named_symbol, tail, symbol, head;
  for (const auto& [head_end, tail_begin] : find_splits(text)) {
    const QString first = text.first(head_end);
    const QString rest = text.sliced(tail_begin);
    const QuantitySet of_first = index.find_exact(first);
    if (begins_with_of(rest)) continue;
    const bool is_group =
        search_rules().group_names.contains(joined_with_blanks(heading_tokens(first)));
    QuantitySet of_rest = rest.isEmpty() ? QuantitySet() : index.find_exact(rest);
    if (!is_group && symbol_readings(rest).empty()) of_rest &= ~contradicted;
    if (of_rest.any() && (of_first.any() || is_group)) {
      tail |= of_rest;
      const QuantitySet common = of_rest & of_first;
      both |= common;
      if (of_first.any() && is_symbol_with_index(rest))
        named_symbol |= common.any() ? common : of_rest;
    } else if (has_symbol_character(rest)) {
      symbol |= of_rest;
    }
    if (of_first.any() && std::ranges::none_of(rest, is_heading_blank) &&
        !symbol_readings(rest).empty())
      head |= of_first;
  }
  // "Pore pressure (Δu)" is Δu, and no pore pressure with a word to be dropped.
  levels.insert(levels.begin() + 1, {NameMatch::tail, named_symbol});
  levels.insert(levels.end(), {{NameMatch::tail, both},
                               {NameMatch::tail, tail},
                               {NameMatch::symbol, symbol},
                               {NameMatch::head, head}});
  return both.any();
}

void append_phrases(const std::vector<QString>& tokens, const QuantitySet& contradicted,
                    SearchLevels& levels) {
  for (const auto& match : NameIndex::get().phrases().find(tokens))
    levels.push_back({NameMatch::words,
                      QuantitySet().set(static_cast<std::size_t>(match.number)) & ~contradicted});
}

/// The quantities that a heading without its unit can mean, the best first.
SearchLevels search_name(const QString& text) {
  const NameIndex& index = NameIndex::get();
  SearchLevels levels{{NameMatch::exact, index.find_exact(text)}};
  // A whole name is more than its words: "effective radial stress" is no radial stress.
  bool is_named = levels.front().found.any();
  if (!is_named) {
    const auto tokens = heading_tokens(text);
    const QuantitySet contradicted = index.composed().find_contradicted(tokens);
    append_shorter_forms(text, levels);
    is_named = append_tails(text, contradicted, levels);
    const bool is_no_reading = std::ranges::any_of(levels, [](const SearchLevel& level) {
      return level.how == NameMatch::kept_word && has_ignored(level.found);
    });
    if (is_no_reading && !is_named)  // "Max. principal stress σ1" is named
      std::erase_if(levels,
                    [](const SearchLevel& level) { return level.how != NameMatch::kept_word; });
    else if (!is_named)
      append_phrases(tokens, contradicted, levels);
  }
  const std::size_t own = levels.size();
  for (std::size_t i = 0; i < own; ++i)
    levels.push_back({NameMatch::borrowed, index.find_borrowers(levels[i].found), levels[i].how});
  return levels;
}

/// True if a heading names a quantity that can have one of `units`; without units, as a whole. A
/// name of an ignored column ("Ch2") has no unit: "Ch2 t" is a time, not tonnes.
bool names_quantity(const QString& name, const std::vector<const UnitName*>& units) {
  const NameIndex& index = NameIndex::get();
  if (units.empty()) return index.find_exact(name).any();
  QuantitySet fitting = find_fitting(units);
  for (std::size_t i = 0; i < lexicon_quantities().size(); ++i)
    if (lexicon_quantities()[i].dimension == "any") fitting.reset(i);
  return std::ranges::any_of(search_name(name),
                             [&](const auto& level) { return (level.found & fitting).any(); });
}

void append_candidates(const SearchLevels& levels, const QuantitySet& fitting, QuantitySet& seen,
                       std::vector<NameCandidate>& candidates) {
  const auto& quantities = lexicon_quantities();
  for (const auto& [how, found, lender] : levels) {
    const QuantitySet fresh = found & fitting & ~seen;
    for (std::size_t i = 0; i < quantities.size(); ++i)
      if (fresh[i]) candidates.push_back({&quantities[i], how, lender});
    seen |= fresh;
  }
}

HeadingNames search_heading(std::string_view heading, std::string_view unit_of_row) {
  constexpr std::size_t kMaxHeadingBytes = 800;
  constexpr qsizetype kMaxHeadingLength = 200;
  const QString text = heading.size() > kMaxHeadingBytes
                           ? QString()
                           : without_outer(repair_heading(heading), u" _\"");
  if (heading.size() > kMaxHeadingBytes || text.size() > kMaxHeadingLength)
    return {.name = std::string(heading)};
  const NameIndex& index = NameIndex::get();
  const auto [name, unit] = split_unit(text, names_quantity);
  const auto row_units = find_unit_names(unit_of_row);
  HeadingNames names{.name = name.toStdString(), .unit = unit.toStdString()};
  QuantitySet seen;
  if (!unit.isEmpty())
    append_candidates({{NameMatch::exact, index.find_exact(text)}}, find_fitting(row_units), seen,
                      names.candidates);
  const auto units = row_units.empty() && !unit.isEmpty() ? find_units(unit) : row_units;
  append_candidates(search_name(name), find_fitting(units), seen, names.candidates);
  return names;
}

}  // namespace

HeadingNames find_names(std::string_view heading, std::string_view unit_of_row) {
  constexpr std::size_t kMaxRemembered = 4096;
  thread_local std::map<std::pair<std::string, std::string>, HeadingNames> remembered;
  std::pair<std::string, std::string> key(heading, unit_of_row);
  const auto known = remembered.find(key);
  if (known != remembered.end()) return known->second;
  if (remembered.size() >= kMaxRemembered) remembered.clear();
  return remembered.emplace(std::move(key), search_heading(heading, unit_of_row)).first->second;
}

}  // namespace triax::lab
