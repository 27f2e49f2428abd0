// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/unit_names.hpp"

#include <QHash>
#include <QSet>
#include <deque>

#include "lab/base/embedded.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/intake/names/heading_form.hpp"

namespace triax::lab {
namespace {

bool is_opening(QChar c) { return c == u'(' || c == u'[' || c == u'{'; }
bool is_closing(QChar c) { return c == u')' || c == u']' || c == u'}'; }

/// Lower case, without spaces, "^", enclosing brackets and full stops that are not between digits.
QString unit_key(const QString& repaired) {
  QString text;
  for (const QChar c : fold_heading(repaired))
    if (!c.isSpace() && c != u'^') text += c;
  if (text.size() >= 2 && is_opening(text.front()) && is_closing(text.back()))
    text = text.sliced(1, text.size() - 2);
  QString key;
  for (qsizetype i = 0; i < text.size(); ++i) {
    const bool between_digits =
        i > 0 && i + 1 < text.size() && text[i - 1].isDigit() && text[i + 1].isDigit();
    if (text[i] != u'.' || between_digits) key += text[i];
  }
  return key;
}

struct UnitTable {
  std::deque<UnitName> units;
  QHash<QString, std::vector<const UnitName*>> by_key;

  void add(const TomlTable& row);
};

QString key_of_spelling(const std::string& spelling) { return unit_key(repair_heading(spelling)); }

/// Ambiguous spellings are a row of their own.
void UnitTable::add(const TomlTable& row) {
  UnitName unit{.name = row.required_text("name"),
                .dimension = row.required_text("dimension"),
                .factor = row.required_number("factor"),
                .offset = row.number("offset").value_or(0),
                .power = row.number("power").value_or(1),
                .can_end_heading = row.flag("loose").value_or(true)};
  UnitName ambiguous = unit;
  ambiguous.is_ambiguous = true;
  ambiguous.decided_by = row.text("decided_by").value_or("");
  const UnitName* const clear_unit = &units.emplace_back(std::move(unit));
  const UnitName* const ambiguous_unit = &units.emplace_back(std::move(ambiguous));
  QSet<QString> ambiguous_keys;
  for (const std::string& spelling : row.texts("ambiguous"))
    ambiguous_keys.insert(key_of_spelling(spelling));
  for (const std::string& spelling : row.texts("spellings")) {
    const QString key = key_of_spelling(spelling);
    by_key[key].push_back(ambiguous_keys.contains(key) ? ambiguous_unit : clear_unit);
  }
}

UnitTable read_unit_table() {
  UnitTable table;
  for (const EmbeddedFile& file : kUnitFiles)
    for (const TomlTable& row : TomlTable::parse(file.text, "units.toml").tables("unit"))
      table.add(row);
  return table;
}

const UnitTable& unit_table() {
  static const UnitTable table = read_unit_table();
  return table;
}

}  // namespace

std::vector<const UnitName*> find_units(const QString& repaired) {
  constexpr qsizetype kMaxUnitLength = 40;
  return repaired.size() > kMaxUnitLength ? std::vector<const UnitName*>{}
                                          : unit_table().by_key.value(unit_key(repaired));
}

std::vector<const UnitName*> units_of(std::string_view dimension) {
  std::vector<const UnitName*> out;
  for (const UnitName& unit : unit_table().units)
    if (unit.dimension == dimension && !unit.is_ambiguous) out.push_back(&unit);
  return out;
}

std::vector<const UnitName*> find_unit_names(std::string_view text) {
  return find_units(repair_heading(text));
}

}  // namespace triax::lab
