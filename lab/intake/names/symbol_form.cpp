// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/symbol_form.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "lab/intake/names/heading_form.hpp"
#include "lab/intake/names/lexicon_file.hpp"

namespace triax::lab {
namespace {

using Spellings = std::vector<QString>;

Spellings read_spellings(const TomlTable& table, const char* key) {
  Spellings spellings;
  for (const std::string& text : table.texts(key))
    spellings.push_back(QString::fromStdString(text));
  return spellings;
}

/// A letter with an index, or without one.
struct Symbol {
  QString name;
  Spellings letters;
  Spellings indices;
};

struct SymbolRules {
  std::vector<Symbol> symbols;
  Spellings differences;  ///< of δ in front of a symbol
  Spellings suffixes;
  qsizetype max_suffix_length = 0;
  Spellings marks;  ///< of an effective stress, the longest first
};

SymbolRules read_symbol_rules() {
  const TomlTable file = read_lexicon_file("normalise");
  SymbolRules rules;
  for (const TomlTable& letter : file.tables("letters")) {
    const QString name = QString::fromStdString(letter.required_text("symbol"));
    const Spellings written = read_spellings(letter, "written");
    if (letter.flag("prefix").value_or(false)) rules.differences = written;
    rules.symbols.push_back({name, written, {QString()}});
    for (const TomlTable& index : file.tables("indices"))
      if (QString::fromStdString(index.required_text("letters")).contains(name))
        rules.symbols.push_back({name + QString::fromStdString(index.required_text("symbol")),
                                 written, read_spellings(index, "written")});
  }
  rules.suffixes = read_spellings(file.required_table("suffixes"), "written");
  rules.suffixes.emplace_back();
  rules.max_suffix_length = std::ranges::max(rules.suffixes, {}, &QString::size).size();
  rules.marks = read_spellings(file.required_table("effective"), "marks");
  std::ranges::stable_sort(rules.marks, std::ranges::greater{}, &QString::size);
  return rules;
}

const SymbolRules& symbol_rules() {
  static const SymbolRules rules = read_symbol_rules();
  return rules;
}

/// The text as it is in a reading, if it is a suffix or empty.
std::optional<QString> read_suffix(QStringView text) {
  const SymbolRules& rules = symbol_rules();
  if (text.size() > rules.max_suffix_length ||
      std::ranges::find(rules.suffixes, text) == rules.suffixes.end())
    return std::nullopt;
  return text == u"o" ? QString(u'0') : text.toString();
}

/// The suffix of a text that is a letter and an index of `symbol` with a suffix.
std::optional<QString> find_suffix(QStringView text, const Symbol& symbol) {
  for (const QString& letter : symbol.letters) {
    if (!text.startsWith(letter)) continue;
    const QStringView behind_letter = text.sliced(letter.size());
    for (const QString& index : symbol.indices)
      if (behind_letter.startsWith(index))
        if (auto suffix = read_suffix(behind_letter.sliced(index.size()))) return suffix;
  }
  return std::nullopt;
}

/// Symbols of `text`, each behind `difference`, with the mark of an effective stress.
void append_readings(QStringView text, const QString& difference, const QString& mark,
                     std::vector<QString>& readings) {
  const auto append = [&](const QString& symbol, const std::optional<QString>& suffix) {
    if (!suffix) return;
    QString reading = difference + symbol + mark + *suffix;
    if (std::ranges::find(readings, reading) == readings.end())
      readings.push_back(std::move(reading));
  };
  for (const Symbol& symbol : symbol_rules().symbols)
    append(symbol.name, find_suffix(text, symbol));
  if (!text.empty() && text[0] >= u'a' && text[0] <= u'z')
    append(text[0], read_suffix(text.sliced(1)));
}

/// Readings of a text that is one symbol.
std::vector<QString> part_readings(const QString& part) {
  const SymbolRules& rules = symbol_rules();
  QString plain = part;
  for (const QString& mark : rules.marks)
    if (mark.size() == 1 || plain.size() > mark.size()) plain.remove(mark);
  const QString mark = plain == part ? QString() : QString(u'\'');
  std::vector<QString> readings;
  append_readings(plain, {}, mark, readings);
  for (const QString& difference : rules.differences)
    if (plain.startsWith(difference))
      append_readings(QStringView(plain).sliced(difference.size()), QString(u'δ'), mark, readings);
  return readings;
}

bool is_word_character(QChar c) { return c.isLetterOrNumber() || c == u'_'; }

/// The text inside the brackets around it. Sets `end` to the word behind them.
QString without_outer_brackets(const QString& text, QString& end) {
  const qsizetype last = std::max(text.lastIndexOf(u')'), text.lastIndexOf(u']'));
  if (last < 2 || (text[0] != u'(' && text[0] != u'[')) return text;
  QString inner = text.sliced(1, last - 1);
  const QString behind = text.sliced(last + 1);
  // In "(s1)-(s3)" the outer brackets are no pair.
  const qsizetype opening = inner.indexOf(u'(');
  const QStringView in_front = QStringView(inner).first(opening < 0 ? inner.size() : opening);
  if (!std::ranges::all_of(behind, is_word_character) || in_front.contains(u')') ||
      in_front.contains(u']'))
    return text;
  end = behind;
  return inner;
}

/// "s1-s3" is "s1", "-", "s3".
std::vector<QString> split_at_operators(const QString& text) {
  std::vector<QString> parts{QString()};
  for (const QChar c : text) {
    if (c == u'-' || c == u'+' || c == u'/' || c == u'=') {
      parts.emplace_back(c);
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

bool is_gap(QChar c) { return c == u' ' || c == u'_' || c == u'.' || c == u'*' || c.isSpace(); }

bool is_bracket(QChar c) {
  constexpr std::u16string_view kBrackets = u"()[]{}<>";
  return kBrackets.find(c.unicode()) != std::u16string_view::npos;
}

}  // namespace

std::vector<QString> symbol_readings(const QString& repaired) {
  constexpr qsizetype kMaxExpression = 20;
  if (std::ranges::count_if(repaired, [](QChar c) { return !is_gap(c) && !is_bracket(c); }) >
      kMaxExpression)
    return {};
  QString text = fold_heading(repaired);
  text.removeIf(is_gap);
  QString end;
  text = without_outer_brackets(text, end);
  text.removeIf(is_bracket);
  const std::vector<QString> parts = split_at_operators(text);
  std::vector<QString> readings{QString()};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<QString> options = i % 2 == 0 ? part_readings(parts[i]) : std::vector<QString>{};
    if (options.empty() && parts.size() == 1) return {};
    if (options.empty()) options = {parts[i] == u"-" ? QString() : parts[i]};
    std::vector<QString> longer;
    for (const QString& reading : readings)
      for (const QString& option : options) longer.push_back(reading + option);
    readings = std::move(longer);
  }
  for (QString& reading : readings) reading += end;
  return readings;
}

}  // namespace triax::lab
