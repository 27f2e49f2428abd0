// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/heading_unit.hpp"

#include <QRegularExpression>
#include <algorithm>

#include "lab/intake/names/heading_form.hpp"
#include "lab/intake/names/lexicon_file.hpp"

namespace triax::lab {
namespace {

using IsName = std::function<bool(const QString&, const std::vector<const UnitName*>&)>;

const std::vector<QString>& unit_separators() {
  static const std::vector<QString> separators = [] {
    std::vector<QString> texts;
    for (const auto& text :
         read_lexicon_file("normalise").required_table("unit").texts("separators"))
      texts.push_back(QString::fromStdString(text));
    return texts;
  }();
  return separators;
}

/// "CellPress" is "Cell Press". "kN" is one word.
QString with_blanks_before_capitals(const QString& text) {
  QString spaced;
  for (const QChar c : text) {
    const bool is_behind_small = spaced.size() > 1 && spaced.back() >= u'a' &&
                                 spaced.back() <= u'z' && spaced[spaced.size() - 2].isLetter();
    if (c >= u'A' && c <= u'Z' && is_behind_small) spaced += u' ';
    spaced += c;
  }
  return spaced;
}

/// The unit inside the last bracket with one. Round brackets may be inside another bracket.
NameAndUnit split_bracket(const QString& text) {
  static const QRegularExpression pattern(
      R"([ _]*[(\[{<]([^()\[\]{}<>]*(?:\([^()]*\))?[^()\[\]{}<>]*)[)\]}>])");
  NameAndUnit parts{text, {}};
  auto matches = pattern.globalMatch(text);
  while (matches.hasNext()) {
    const auto match = matches.next();
    if (!find_units(match.captured(1)).empty())
      parts = {text.first(match.capturedStart()) + text.sliced(match.capturedEnd()),
               match.captured(1).trimmed()};
  }
  parts.name = without_outer(parts.name, u" _");
  return parts;
}

/// The unit behind the last `separator`.
NameAndUnit split_at(const QString& text, const QString& separator, const IsName& is_name) {
  const bool is_strong = separator == u"," || separator == u"/";
  const auto can_end = [](const QString& unit, const std::vector<const UnitName*>& units) {
    return unit.contains(u'/') || std::ranges::any_of(units, &UnitName::can_end_heading);
  };
  // The longest unit first: "Load/kN/m2" is in kN/m2.
  for (qsizetype at = text.indexOf(separator); at >= 0; at = text.indexOf(separator, at + 1)) {
    const QString unit = text.sliced(at + separator.size());
    const QString name = without_outer(text.first(at), u" _,/");
    const auto units = find_units(unit);
    // "ε_v" has an index.
    const bool is_index = separator == u"_" && unit.size() == 1 && unit.front().isLetter() &&
                          !name.isEmpty() && name.back().script() == QChar::Script_Greek;
    if (units.empty() || is_index || !(is_strong || can_end(unit, units)) || !is_name(name, units))
      continue;
    return {name, unit.trimmed()};
  }
  return {};
}

/// The longest unit of all separators: "Shift/0.01 mm" is in hundredths.
NameAndUnit split_longest(const QString& text, const IsName& is_name) {
  NameAndUnit longest;
  for (const QString& separator : unit_separators())
    if (NameAndUnit parts = split_at(text, separator, is_name);
        parts.unit.size() > longest.unit.size())
      longest = std::move(parts);
  return longest;
}

/// True if a unit behind this name makes it a rate: "Axial strain per" of "minute".
bool ends_as_rate(const QString& name) {
  static const std::vector<std::string> words =
      read_lexicon_file("normalise").required_table("unit").texts("rates");
  const std::string last = name.sliced(name.lastIndexOf(u' ') + 1).toStdString();
  return std::ranges::find(words, last) != words.end();
}

/// Units that are no names, whatever stands before them: "mm", not "t".
bool is_clear_unit(const QString& name, const std::vector<const UnitName*>& units) {
  return !name.isEmpty() && !ends_as_rate(name) &&
         std::ranges::none_of(units, &UnitName::is_ambiguous);
}

}  // namespace

NameAndUnit split_unit(const QString& repaired, const IsName& is_name) {
  if (NameAndUnit parts = split_bracket(repaired); !parts.unit.isEmpty()) return parts;
  if (repaired.endsWith(u'‰')) return {without_outer(repaired.chopped(1), u" _,/"), u"‰"_qs};
  if (is_name(repaired, {})) return {repaired, {}};
  if (NameAndUnit parts = split_longest(repaired, is_name); !parts.unit.isEmpty()) return parts;
  NameAndUnit parts = split_at(with_blanks_before_capitals(repaired), " ", is_name);
  if (parts.unit.isEmpty()) parts = split_longest(repaired, is_clear_unit);
  return parts.unit.isEmpty() ? NameAndUnit{repaired, {}} : parts;
}

}  // namespace triax::lab
