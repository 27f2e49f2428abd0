// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/labels.hpp"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/intake/names/heading_form.hpp"
#include "lab/intake/names/label_index.hpp"
#include "lab/intake/names/label_text.hpp"
#include "lab/intake/names/lexicon_quantity.hpp"

namespace triax::lab {
namespace {

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
  explicit LabelReader(std::vector<LabelValue>& values) : values_(values) {}

  /// Reads one line.
  void read(const std::vector<QString>& cells, std::int64_t line);
  /// Reads the line below one of names only.
  void read_below(const std::vector<QString>& names, const std::vector<QString>& cells,
                  std::int64_t line);

 private:
  /// A state of the specimen above a column, or the title of the labels below it.
  struct StateTitle {
    std::size_t cell = 0;
    SpecimenState state{};
  };

  bool read_states(const std::vector<QString>& cells);
  NamedLabels in_state(NamedLabels named, std::size_t cell) const;
  bool read_pair(QString& text);
  bool read_text(const QString& text);
  static bool has_labels(const QString& text);
  void read_without_mark(const QString& text);
  void read_cells(const std::vector<QString>& cells, bool is_line);
  bool read_number_behind_blank(const QString& text);
  bool add_number(const NamedLabels& any_state, const QString& number, const QString& unit);
  bool add_text(const NamedLabels& named, const QString& text);
  bool add_cells(const NamedLabels& named, const std::vector<QString>& cells, std::size_t& next);
  void add_more_cells(const NamedLabels& named, const std::vector<QString>& cells,
                      std::size_t& next);
  void check_more_numbers(const std::vector<QString>& cells, std::size_t next,
                          std::size_t values_before);
  void append(const std::vector<LabelValue>& found);

  std::vector<LabelValue>& values_;
  std::int64_t line_ = 0;
  std::size_t cell_ = 0;        ///< of the label in its line
  std::size_t value_cell_ = 0;  ///< of its value
  std::vector<StateTitle> states_;
  std::size_t values_before_ = 0;  ///< when the states were read
};

void LabelReader::append(const std::vector<LabelValue>& found) {
  for (LabelValue value : found) {
    value.line = line_;
    value.cell = cell_;
    value.is_ambiguous = found.size() > 1;
    values_.push_back(std::move(value));
  }
}

/// By the last title of a state left of the value. A label with a state of its own keeps it.
NamedLabels LabelReader::in_state(NamedLabels named, std::size_t cell) const {
  const auto title = std::find_if(states_.rbegin(), states_.rend(),
                                  [&](const StateTitle& one) { return one.cell <= cell; });
  const bool has_own =
      std::ranges::any_of(named.labels, [](const Label* label) { return !label->base.empty(); });
  if (title != states_.rend() && !has_own)
    named.labels = LabelIndex::get().in_state(named.labels, title->state);
  return named;
}

bool LabelReader::add_number(const NamedLabels& any_state, const QString& number,
                             const QString& unit) {
  const auto decimal = decimal_number(number);
  if (!decimal) return false;
  const NamedLabels named = in_state(any_state, value_cell_);
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

/// Reads one pair with a colon or an equals sign from `text`, and what is in front of it, and
/// removes both. False if there is none.
bool LabelReader::read_pair(QString& text) {
  static const QRegularExpression mark("[:=]");
  const qsizetype at = text.indexOf(mark);
  if (at < 0) return false;
  QString before = text.first(at);
  text.remove(0, at + 1);
  const NamedLabels named = take_last_label(before);
  if (!named.labels.empty()) read_without_mark(before);
  const auto amount = read_amount(text);
  if (amount && named.has_number() &&
      add_number(named, amount->number, amount->unit.isEmpty() ? named.unit : amount->unit)) {
    text = amount->rest;
  } else if (named.has_text()) {
    const qsizetype end = end_of_text(text);
    add_text(named, text.first(end).trimmed());
    text.remove(0, end);
  }
  return true;
}

/// Reads labels without a colon or an equals sign: "Initial height  76 mm", or several between
/// delimiters.
void LabelReader::read_without_mark(const QString& text) {
  const std::size_t before = values_.size();
  std::vector<QString> parts;
  for (const QString& part : text.split(label_delimiter()))
    if (!part.trimmed().isEmpty()) parts.push_back(part.trimmed());
  if (parts.size() > 1) read_cells(parts, false);
  if (values_.size() == before) read_number_behind_blank(text);
}

/// Reads all labels inside one text. False if there is none.
bool LabelReader::read_text(const QString& text) {
  const std::size_t before = values_.size();
  QString rest = text;
  while (read_pair(rest)) continue;
  read_without_mark(rest);
  return values_.size() > before;
}

/// True if a text has labels with values of its own and is the value of no other.
bool LabelReader::has_labels(const QString& text) {
  std::vector<LabelValue> values;
  return LabelReader(values).read_text(text);
}

/// "Initial height 76 mm", with any labels behind it.
bool LabelReader::read_number_behind_blank(const QString& text) {
  static const QRegularExpression number(R"(\s[-+]?\d)");
  const qsizetype at = text.indexOf(number);
  if (at <= 0) return false;
  const NamedLabels named = find_named_labels(text.first(at).trimmed());
  const auto amount = read_amount(text.sliced(at));
  if (!amount || !named.has_number() ||
      !add_number(named, amount->number, amount->unit.isEmpty() ? named.unit : amount->unit))
    return false;
  read_without_mark(amount->rest);
  return true;
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
  // "Specimen: B" names a specimen, not the parameter B, which would have a value behind it.
  const bool is_letter =
      cells[at].size() == 1 && cells[at].front().isLetter() &&
      std::all_of(cells.begin() + static_cast<std::ptrdiff_t>(at) + 1, cells.end(),
                  [](const QString& cell) { return cell.isEmpty(); });
  const bool is_label = !is_letter && !find_named_labels(cells[at]).labels.empty();
  if (is_label || has_labels(cells[at]) || !add_text(named, cells[at])) return false;
  next = at + 1;
  return true;
}

/// The values of the same label in other states, each below the title of its state.
void LabelReader::add_more_cells(const NamedLabels& named, const std::vector<QString>& cells,
                                 std::size_t& next) {
  for (std::size_t at = next; at < cells.size(); ++at) {
    const auto amount = read_amount(cells[at]);
    if (std::ranges::find(states_, at, &StateTitle::cell) == states_.end()) continue;
    if (!amount || !amount->rest.trimmed().isEmpty()) return;
    value_cell_ = at;
    add_number(named, amount->number, amount->unit.isEmpty() ? named.unit : amount->unit);
    next = at + 1;
  }
}

/// Another number behind a value is that of another specimen, or repeats the measurement: which
/// one counts is not known if they differ.
void LabelReader::check_more_numbers(const std::vector<QString>& cells, std::size_t next,
                                     std::size_t values_before) {
  if (next >= cells.size()) return;
  const auto value = read_amount(cells[next - 1]), other = read_amount(cells[next]);
  if (!value || !other || !value->rest.trimmed().isEmpty() || !other->rest.trimmed().isEmpty())
    return;
  const double a = decimal_number(value->number).value_or(0);
  const double b = decimal_number(other->number).value_or(0);
  if (are_repeated(a, b)) return;
  for (std::size_t i = values_before; i < values_.size(); ++i)
    if (values_[i].value) values_[i].is_ambiguous = true;
}

/// True for a line that only names states of the specimen: a title, or several above columns.
bool LabelReader::read_states(const std::vector<QString>& cells) {
  std::vector<StateTitle> found;
  std::size_t others = 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (cells[cell].isEmpty()) continue;
    if (const auto state = LabelIndex::get().find_state(cells[cell]))
      found.push_back({cell, *state});
    else if (read_amount(cells[cell]))
      return false;
    else
      ++others;
  }
  if (found.empty() || (found.size() == 1 && others > 0)) return false;
  states_ = std::move(found);
  values_before_ = values_.size();
  return true;
}

void LabelReader::read(const std::vector<QString>& cells, std::int64_t line) {
  line_ = line;
  if (read_states(cells)) return;
  const bool is_blank = std::ranges::all_of(cells, &QString::isEmpty);
  if (is_blank && values_.size() > values_before_) states_.clear();
  read_cells(cells, true);
}

void LabelReader::read_below(const std::vector<QString>& names, const std::vector<QString>& cells,
                             std::int64_t line) {
  line_ = line;
  for (cell_ = 0; cell_ < names.size(); ++cell_) {
    if (names[cell_].isEmpty()) continue;
    value_cell_ = cell_;
    std::size_t next = cell_;
    add_cells(find_named_labels(names[cell_]),
              {cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(cell_) + 1}, next);
  }
}

/// `is_line`: the cells are those of the line, not parts of one.
void LabelReader::read_cells(const std::vector<QString>& cells, bool is_line) {
  static const QRegularExpression mark("[:=]");
  for (std::size_t i = 0; i < cells.size();) {
    const QString text = without_outer(cells[i], u" :=#%/!*;");
    if (is_line) cell_ = value_cell_ = i;
    ++i;
    if (text.contains(mark) && read_text(text)) continue;
    const NamedLabels named = find_named_labels(text);
    if (named.labels.empty()) {
      read_without_mark(text);
      continue;
    }
    while (is_line && value_cell_ + 1 < cells.size() && cells[++value_cell_].isEmpty()) continue;
    const std::size_t values_before = values_.size();
    if (!add_cells(named, cells, i)) {
      read_without_mark(text);
    } else if (is_line) {
      add_more_cells(named, cells, i);
      check_more_numbers(cells, i, values_before);
    }
  }
}

std::vector<QString> cells_of_line(const std::vector<std::string>& line) {
  constexpr std::size_t kMaxCellBytes = 1000;
  std::vector<QString> cells;
  cells.reserve(line.size());
  for (const std::string& cell : line)
    cells.push_back(cell.size() > kMaxCellBytes ? QString()
                                                : without_outer(repair_heading(cell), u" \"'\r\n"));
  return cells;
}

bool are_below_each_other(const std::vector<QString>& a, const std::vector<QString>& b) {
  for (std::size_t cell = 0; cell < std::max(a.size(), b.size()); ++cell)
    if ((cell >= a.size() || a[cell].isEmpty()) != (cell >= b.size() || b[cell].isEmpty()))
      return false;
  return true;
}

/// A line of names with one line of values below it. With more, it is a table.
bool has_values_below(const std::vector<std::vector<QString>>& lines, std::size_t at) {
  const auto& names = lines[at];
  if (at + 1 >= lines.size() || !are_below_each_other(names, lines[at + 1])) return false;
  if (at + 2 < lines.size() && are_below_each_other(names, lines[at + 2])) return false;
  std::size_t count = 0;
  for (const QString& name : names) {
    if (name.isEmpty()) continue;
    if (find_named_labels(name).labels.empty()) return false;
    ++count;
  }
  return count > 1 && std::ranges::any_of(lines[at + 1], [](const QString& cell) {
           return read_amount(cell).has_value();
         });
}

}  // namespace

std::vector<LabelValue> find_labels(const std::vector<std::vector<std::string>>& lines,
                                    std::int64_t first_line) {
  std::vector<std::vector<QString>> cells;
  cells.reserve(lines.size());
  for (const auto& line : lines) cells.push_back(cells_of_line(line));
  std::vector<LabelValue> values;
  LabelReader reader(values);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (has_values_below(cells, i)) {
      reader.read_below(cells[i], cells[i + 1], first_line + static_cast<std::int64_t>(i) + 1);
      ++i;
    } else {
      reader.read(cells[i], first_line + static_cast<std::int64_t>(i));
    }
  }
  return values;
}

}  // namespace triax::lab
