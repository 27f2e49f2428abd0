// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/labels.hpp"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/intake/names/heading_form.hpp"
#include "lab/intake/names/heading_unit.hpp"
#include "lab/intake/names/label_index.hpp"
#include "lab/intake/names/lexicon_quantity.hpp"

namespace triax::lab {
namespace {

struct NamedLabels {
  std::vector<const Label*> labels;
  QString unit;

  bool has_number() const { return std::ranges::any_of(labels, &Label::is_number); }
  bool has_text() const { return !std::ranges::all_of(labels, &Label::is_number); }
};

NamedLabels find_named_labels(const QString& text) {
  const LabelIndex& index = LabelIndex::get();
  const auto is_name = [&](const QString& name, const std::vector<const UnitName*>& units) {
    return std::ranges::any_of(index.find(name),
                               [&](const Label* label) { return label->fits(units); });
  };
  constexpr qsizetype kMaxLabelLength = 100;
  if (text.isEmpty() || text.size() > kMaxLabelLength) return {};
  const auto [name, unit] = split_unit(text, is_name);
  return {index.find(name), unit};
}

/// A number with its unit at the beginning of a text.
struct Amount {
  QString number;
  QString unit;
  QString rest;  ///< of the text
};

std::optional<Amount> read_amount(const QString& text) {
  static const QRegularExpression pattern(R"(^\s*([-+]?[.,]?\d[\d.,]*(?:[eE][-+]?\d+)?))");
  const auto match = pattern.match(text);
  if (!match.hasMatch()) return std::nullopt;
  QString number = match.captured(1);
  while (number.back() == u'.' || number.back() == u',') number.chop(1);
  const QString behind = text.sliced(match.capturedStart(1) + number.size());
  static const QRegularExpression unit_end(R"([;|]|,(?=\s|$)|(?<=\S)\s\s)");
  const qsizetype end = behind.indexOf(unit_end);
  const QString whole = (end < 0 ? behind : behind.first(end)).trimmed();
  const QString word = whole.section(u' ', 0, 0);
  for (const QString& unit : {whole, word})
    if (!find_units(unit).empty())
      return Amount{number, unit, behind.sliced(behind.indexOf(unit) + unit.size())};
  return Amount{number, {}, behind};
}

/// The number with its one mark, or the last of two kinds of marks, as decimal mark.
std::optional<double> decimal_number(QString text) {
  const qsizetype mark = std::max(text.lastIndexOf(u'.'), text.lastIndexOf(u','));
  if (mark >= 0) {
    const bool is_repeated = text.count(text[mark]) > 1;
    QString whole = text.first(mark);
    whole.remove(u'.').remove(u',');
    text = whole + (is_repeated ? "" : ".") + text.sliced(mark + 1);
  }
  bool ok = false;
  const double value = text.toDouble(&ok);
  return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// The number with its mark between thousands, if it can be that: "86,193".
std::optional<double> grouped_number(const QString& text) {
  static const QRegularExpression grouped(R"(^[-+]?\d{1,3}[.,]\d{3}$)");
  if (!grouped.match(text).hasMatch()) return std::nullopt;
  return QString(text).remove(u'.').remove(u',').toDouble();
}

bool is_usual(const Label& label, double value) {
  return !label.usual || (value >= label.usual->first && value <= label.usual->second);
}

double to_canonical(const Label& label, const std::vector<const UnitName*>& units, double value) {
  for (const UnitName* unit : units)
    if (unit->dimension == label.dimension) {
      const auto conversion = unit_conversion(*unit, *label.unit);
      return conversion.factor * std::pow(value, conversion.power) + conversion.offset;
    }
  return value;
}

class LabelReader {
 public:
  LabelReader(std::int64_t line, std::vector<LabelValue>& values) : line_(line), values_(values) {}

  void read(const std::vector<std::string>& line);

 private:
  bool read_pair(QString& text);
  bool read_number_behind_blank(const QString& text);
  bool add_number(const NamedLabels& named, const QString& number, const QString& unit);
  bool add_text(const NamedLabels& named, const QString& text);
  bool add_cells(const NamedLabels& named, const std::vector<QString>& cells, std::size_t& next);
  void append(const std::vector<LabelValue>& found);

  std::int64_t line_;
  std::vector<LabelValue>& values_;
};

void LabelReader::append(const std::vector<LabelValue>& found) {
  for (LabelValue value : found) {
    value.line = line_;
    value.is_ambiguous = found.size() > 1;
    values_.push_back(std::move(value));
  }
}

bool LabelReader::add_number(const NamedLabels& named, const QString& number, const QString& unit) {
  const auto decimal = decimal_number(number);
  if (!decimal) return false;
  const auto units = find_units(unit);
  std::vector<LabelValue> found;
  for (const Label* label : named.labels) {
    if (!label->is_number()) {
      if (units.empty())
        found.push_back(
            {.name = label->name, .metadata = label->metadata, .text = number.toStdString()});
      continue;
    }
    if (!label->fits(units)) continue;
    double value = to_canonical(*label, units, *decimal);
    const double grouped = to_canonical(*label, units, grouped_number(number).value_or(*decimal));
    if (!is_usual(*label, value) && is_usual(*label, grouped)) value = grouped;
    found.push_back({.name = label->name,
                     .metadata = label->metadata,
                     .text = number.toStdString(),
                     .value = value,
                     .unit = unit.toStdString(),
                     .is_usual = is_usual(*label, value)});
  }
  append(found);
  return !found.empty();
}

bool LabelReader::add_text(const NamedLabels& named, const QString& text) {
  std::vector<LabelValue> found;
  for (const Label* label : named.labels)
    if (!label->is_number())
      found.push_back(
          {.name = label->name, .metadata = label->metadata, .text = text.toStdString()});
  if (!text.isEmpty()) append(found);
  return !text.isEmpty() && !found.empty();
}

/// Reads one pair with a colon or an equals sign from the beginning of `text` and removes it. False
/// if there is none.
bool LabelReader::read_pair(QString& text) {
  static const QRegularExpression mark("[:=]");
  static const QRegularExpression delimiter(R"([;|]|,(?!\d)|\s\s|\s\()");
  const qsizetype at = text.indexOf(mark);
  if (at < 0) return false;
  const QString before = text.first(at);
  text.remove(0, at + 1);
  const qsizetype start = before.lastIndexOf(delimiter);
  NamedLabels named = find_named_labels(before.sliced(start < 0 ? 0 : start + 1).trimmed());
  const auto amount = read_amount(text);
  if (amount && named.has_number() &&
      add_number(named, amount->number, amount->unit.isEmpty() ? named.unit : amount->unit)) {
    text = amount->rest;
  } else if (named.has_text()) {
    const QString value = text.trimmed();
    const qsizetype end = value.indexOf(delimiter);
    add_text(named, end < 0 ? value : value.first(end).trimmed());
    text = end < 0 ? QString() : value.sliced(end + 1);
  }
  return true;
}

/// "Initial height  76 mm"
bool LabelReader::read_number_behind_blank(const QString& text) {
  static const QRegularExpression number(R"(\s[-+]?\d)");
  const qsizetype at = text.indexOf(number);
  if (at <= 0) return false;
  const NamedLabels named = find_named_labels(text.first(at).trimmed());
  const auto amount = read_amount(text.sliced(at));
  return amount && named.has_number() &&
         add_number(named, amount->number, amount->unit.isEmpty() ? named.unit : amount->unit);
}

/// The value of a label in the cells from `next` on; sets `next` to the cell behind it.
bool LabelReader::add_cells(const NamedLabels& named, const std::vector<QString>& cells,
                            std::size_t& next) {
  std::size_t at = next;
  while (at < cells.size() && cells[at].isEmpty()) ++at;
  if (at == cells.size()) return false;
  const auto amount = named.has_number() ? read_amount(cells[at]) : std::nullopt;
  if (amount && amount->rest.trimmed().isEmpty()) {
    QString unit = amount->unit.isEmpty() ? named.unit : amount->unit;
    const bool unit_follows = unit.isEmpty() && at + 1 < cells.size() && !cells[at + 1].isEmpty() &&
                              !find_units(cells[at + 1]).empty();
    if (unit_follows && add_number(named, amount->number, cells[at + 1])) {
      next = at + 2;
      return true;
    }
    if (add_number(named, amount->number, unit)) {
      next = at + 1;
      return true;
    }
  }
  if (!find_named_labels(cells[at]).labels.empty() || !add_text(named, cells[at])) return false;
  next = at + 1;
  return true;
}

void LabelReader::read(const std::vector<std::string>& line) {
  constexpr std::size_t kMaxCellBytes = 1000;
  std::vector<QString> cells;
  cells.reserve(line.size());
  for (const std::string& cell : line)
    cells.push_back(cell.size() > kMaxCellBytes ? QString()
                                                : without_outer(repair_heading(cell), u" \"'\r\n"));
  for (std::size_t i = 0; i < cells.size();) {
    const QString text = without_outer(cells[i], u" :=#%/!*;");
    const NamedLabels named = find_named_labels(text);
    ++i;
    if (!named.labels.empty()) {
      add_cells(named, cells, i);
      continue;
    }
    QString rest = text;
    if (!text.contains(u':') && !text.contains(u'=')) read_number_behind_blank(text);
    while (read_pair(rest)) continue;
  }
}

}  // namespace

std::vector<LabelValue> find_labels(const std::vector<std::vector<std::string>>& lines,
                                    std::int64_t first_line) {
  std::vector<LabelValue> values;
  for (const auto& line : lines) LabelReader(first_line++, values).read(line);
  return values;
}

}  // namespace triax::lab
