// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/proposed_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/intake/gauge_columns.hpp"
#include "lab/intake/labels_above.hpp"
#include "lab/intake/names/record_units.hpp"
#include "lab/intake/text/number_cell.hpp"
#include "lab/intake/text/row_model.hpp"
#include "lab/records/column_plan.hpp"

namespace triax::lab {
namespace {

constexpr const char* kHowToAnswer =
    "`triax replay FILE --propose > my.toml` writes what was understood; correct it and use "
    "--dialect my.toml";

/// The role of a quantity of the lexicon in a record; nothing if the record has no use for it.
std::optional<DialectColumn> record_column(const std::string& name) {
  DialectColumn column;
  if (name == "time" || name == "clock") {
    column.role = ColumnRole::time;
  } else if (name == "stage_time") {
    column.role = ColumnRole::stage_time;
  } else if (name == "stage") {
    column.role = ColumnRole::stage;
  } else if (name == "test") {
    column.role = ColumnRole::test;
  } else if (name == "date") {
    column.role = ColumnRole::date;
  } else if (name == "time_of_day") {
    column.role = ColumnRole::time_of_day;
  } else if (const auto quantity = find_quantity(name)) {
    column.quantity = *quantity;
  } else if (const auto source = find_source_quantity(name)) {
    column.role = ColumnRole::source;
    column.source = *source;
  } else {
    return std::nullopt;
  }
  return column;
}

sim::Unit record_unit(const DialectColumn& column) {
  if (column.role == ColumnRole::quantity) return *sim::find_unit(info(column.quantity).unit);
  if (column.role == ColumnRole::source)
    return *sim::find_unit(source_quantities()[index(column.source)].unit);
  return *sim::find_unit("s");
}

/// To SI. A unit has the factor that a dialect gives it, so that both routes agree to the bit.
double scale_of(const DialectColumn& column, const ColumnReading& reading) {
  const sim::Unit unit = record_unit(column);
  if (column.role == ColumnRole::stage || column.role == ColumnRole::test) return 1;
  const auto found = find_record_unit(reading.unit, unit.dimension);
  return reading.sign * (found ? found->scale : reading.factor * unit.scale);
}

/// All but the columns.
TableLayout layout_of_structure(const TableStructure& structure, std::size_t block, Dialect dialect,
                                const std::string& file) {
  TableLayout out;
  out.file = file;
  out.dialect = std::move(dialect);
  if (out.dialect.comment.empty()) out.dialect.comment = structure.comment;
  out.dialect.decimal = structure.decimal;
  out.dialect.thousands = structure.thousands;
  out.head = structure.preamble;
  out.heading_line = structure.heading_lines.empty() ? 0 : structure.heading_lines.back();
  out.first_row_line = structure.first_row_line;
  out.last_row_line = structure.last_row_line;
  out.other_lines = structure.repeated_heading_lines;
  out.heading_separator = out.separator = structure.separator;
  out.cell_count = structure.column_count;
  out.extents = structure.extents;
  if (block > 0) {
    out.first_cell = structure.blocks[block - 1].first_cell;
    out.block_cells = structure.blocks[block - 1].cell_count;
  }
  return out;
}

void note_unused(const std::string& heading, std::int64_t line, Findings& findings) {
  if (heading.empty()) return;
  findings.note("unused " + heading, line, fmt::format("column {} is not used", excerpt(heading)));
}

Dialect plain_dialect() {
  Dialect dialect;
  dialect.name = "table";
  dialect.stage.role = StageRole::shear;
  dialect.stage.control = AxialControl::unknown;
  return dialect;
}

class Layout {
 public:
  Layout(const Proposal& proposal, const std::string& file, Findings& findings)
      : p_(proposal),
        findings_(findings),
        out_(layout_of_structure(proposal.structure, proposal.block, plain_dialect(), file)) {
    out_.labels = proposal.labels;
  }

  TableLayout build() {
    refuse_questions();
    const auto gauges = find_gauge_columns(p_);
    for (std::size_t i = 0; i < p_.table.columns.size(); ++i) {
      const auto gauge = std::ranges::find(gauges, i, &GaugeColumn::column);
      if (gauge != gauges.end())
        add_gauge(*gauge);
      else
        add_column(i);
    }
    drop_second_time();
    note_definitions();
    return std::move(out_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw BadInput(out_.file, out_.heading_line, what + ". " + kHowToAnswer);
  }

  void refuse_questions() const {
    std::vector<std::string> open;
    for (const TableQuestion& question : p_.questions)
      if (must_be_answered(question)) open.push_back(question.text);
    if (!open.empty()) refuse("the file does not decide: " + joined(open, "; "));
  }

  bool must_be_answered(const TableQuestion& question) const {
    using enum TableQuestion::About;
    switch (question.about) {
      case headings:
      case unit:
      case meaning:
        return true;
      case date_order:
        return !p_.has("time") && depends_on_order(question.position);
      case definitions:
        return is_definition_open();
      case sign:
      case value:
        return false;
    }
    return false;
  }

  /// True if the time between the first and the last row differs with day and month exchanged.
  bool depends_on_order(std::size_t position) const {
    const auto column = std::ranges::find(p_.table.columns, position, &TableColumn::position);
    if (column == p_.table.columns.end() || !column->clock) return true;
    ClockFormat other = *column->clock->format;
    other.order =
        other.order == DateOrder::day_first ? DateOrder::month_first : DateOrder::day_first;
    const auto elapsed = [&](const ClockFormat& format) {
      return clock_seconds(format, column->last_cell).value_or(HUGE_VAL) -
             clock_seconds(format, column->first_cell).value_or(0);
    };
    return elapsed(*column->clock->format) != elapsed(other);
  }

  /// True if names and readings of a mean stress or a deviator contradict each other about equally.
  bool is_definition_open() const {
    constexpr std::array kNames{"deviator_stress", "mean_effective_stress", "half_deviator_stress",
                                "mean_effective_stress_2d"};
    return std::ranges::any_of(kNames, [&](const char* name) {
      const ColumnMeaning* const column = p_.meaning.of(name);
      return column && !column->is_decided();
    });
  }

  void add_gauge(const GaugeColumn& gauge) {
    const TableColumn& column = p_.table.columns[gauge.column];
    PlannedColumn planned;
    planned.cell = column.position - 1;
    planned.quantity = gauge.is_force ? Quantity::axial_force : Quantity::axial_displacement;
    planned.heading = column.heading;
    planned.scale = gauge.scale.value();
    findings_.note("gauge " + column.heading, out_.heading_line,
                   gauge.is_force ? fmt::format("the axial force is {:g} N times column {}",
                                                planned.scale, excerpt(column.heading))
                                  : fmt::format("the axial displacement is {:g} mm times column {}",
                                                planned.scale * 1e3, excerpt(column.heading)));
    out_.columns.push_back(std::move(planned));
  }

  void add_column(std::size_t i) {
    const TableColumn& column = p_.table.columns[i];
    const ColumnReading& reading = p_.meaning.columns[i].reading;
    auto as = reading.quantity ? record_column(reading.quantity->name) : std::nullopt;
    if (column.position == p_.test_column) as = DialectColumn{.role = ColumnRole::test};
    if (!as || reading.offset != 0)
      return note_unused(column.heading, out_.heading_line, findings_);
    PlannedColumn planned;
    planned.cell = column.position - 1;
    planned.role = as->role;
    planned.quantity = as->quantity;
    planned.source = as->source;
    planned.heading = column.heading;
    planned.scale = column.clock ? 1 : scale_of(*as, reading);
    planned.holds_words = as->role == ColumnRole::stage && !column.sample.is_number;
    if (column.clock) planned.clock = column.clock->format;
    note_reading(column, reading);
    out_.columns.push_back(std::move(planned));
  }

  /// Notes a column that its name alone does not decide.
  void note_reading(const TableColumn& column, const ColumnReading& reading) {
    if (column.clock || reading.unit_source == UnitSource::name) return;
    const bool is_named = reading.name && *reading.name != NameMatch::borrowed;
    const bool is_unit_said = reading.unit_source != UnitSource::identity;
    if (is_named && is_unit_said && reading.sign > 0) return;
    findings_.note("assumed " + column.heading, out_.heading_line,
                   fmt::format("column {} is read as {} in {}{}: the readings decide it",
                               excerpt(column.heading), reading.quantity->name,
                               reading.unit.empty() ? "plain numbers" : reading.unit,
                               reading.sign < 0 ? " with the opposite sign" : ""));
  }

  /// A time in numbers is the time; dates and clocks beside it only say when the test began.
  void drop_second_time() {
    const auto is_number = [](const PlannedColumn& one) {
      return one.role == ColumnRole::time && (!one.clock || one.clock->is_elapsed);
    };
    const auto first = std::ranges::find_if(out_.columns, is_number);
    if (first == out_.columns.end()) return;
    const std::size_t cell = first->cell;
    std::erase_if(out_.columns, [&](const PlannedColumn& one) {
      const bool is_time = one.role == ColumnRole::time || one.role == ColumnRole::date ||
                           one.role == ColumnRole::time_of_day;
      return is_time && one.cell != cell;
    });
  }

  void note_definitions() {
    for (const TableQuestion& question : p_.questions)
      if (question.about == TableQuestion::About::definitions)
        findings_.note(
            "definitions", out_.heading_line,
            "headings of p' or q: the readings are s' = (σ1′ + σ3′)/2 or t = (σ1 − σ3)/2, "
            "because only then the stresses and the pore pressure agree; read "
            "accordingly");
  }

  const Proposal& p_;
  Findings& findings_;
  TableLayout out_;
};

/// The cells between the table that a dialect describes, else the first one, and `block`.
std::size_t shift_of(const Dialect& dialect, const TableStructure& structure, std::size_t block) {
  if (block == 0) return 0;
  const std::size_t described = std::clamp<std::size_t>(dialect.block, 1, structure.blocks.size());
  const std::size_t from = structure.blocks[described - 1].first_cell;
  return structure.blocks[block - 1].first_cell - from;
}

/// The cell of a dialect's column; nothing if the table does not have it.
std::optional<std::size_t> cell_of(const DialectColumn& column, const TableStructure& structure,
                                   std::size_t shift) {
  if (column.position > 0) return column.position - 1 + shift;
  for (const std::string& name : column.names)
    for (std::size_t cell = shift; cell < structure.headings.size(); ++cell)
      if (matches_name(structure.headings[cell], name) ||
          matches_name(split_heading(structure.headings[cell]).name, name))
        return cell;
  return std::nullopt;
}

/// By the dialect, the heading or the row of units.
double placed_scale(const DialectColumn& column, std::size_t cell, const TableStructure& structure,
                    const std::string& file) {
  if (column.role == ColumnRole::stage || column.role == ColumnRole::test ||
      column.role == ColumnRole::date || column.role == ColumnRole::time_of_day)
    return 1;
  const sim::Unit unit = record_unit(column);
  const std::string heading = cell < structure.headings.size() ? structure.headings[cell] : "";
  std::string text = !column.true_unit.empty() ? column.true_unit : column.unit;
  if (text.empty()) text = split_heading(heading).unit.value_or("");
  if (text.empty() && cell < structure.units.size()) text = structure.units[cell];
  const auto found = find_record_unit(text, unit.dimension);
  if (found) return column.sign * column.factor * found->scale;
  throw BadInput(file, structure.heading_lines.empty() ? 0 : structure.heading_lines.back(),
                 fmt::format("column {} {}: {}; known: {}", cell + 1, excerpt(heading),
                             text.empty() ? "no unit" : "unknown unit " + excerpt(text),
                             record_unit_names(unit.dimension)));
}

/// Labels that the dialect names are read by its keys.
void drop_keys(TableLayout& layout) {
  std::erase_if(layout.labels, [&](const LabelValue& label) {
    const auto& keys = layout.dialect.keys;
    return std::ranges::find(keys, label.metadata, &DialectKey::key) != keys.end();
  });
}

std::string without_digits(std::string_view line) {
  std::string out = folded(line);
  std::erase_if(out, [](char c) { return c >= '0' && c <= '9'; });
  return out;
}

/// The first line above the table that is about its first test only: the last one with a label that
/// a later test has too, or a title that a later test has with another number ("Test 1").
std::int64_t first_own_line(const TableLayout& layout, const std::vector<LabelValue>& of_later,
                            const std::vector<std::string>& lines_of_later) {
  auto first = static_cast<std::int64_t>(layout.head.size()) + 1;
  for (const LabelValue& later : of_later) {
    std::int64_t last = 0;
    for (const LabelValue& label : layout.labels)
      if (label.name == later.name) last = std::max(last, label.line);
    if (last > 0) first = std::min(first, last);
  }
  for (std::size_t i = 0; i < layout.head.size(); ++i) {
    const std::string& line = layout.head[i];
    const bool is_title_again = std::ranges::any_of(lines_of_later, [&](const std::string& later) {
      return later != line && !without_digits(line).empty() &&
             without_digits(later) == without_digits(line);
    });
    if (is_title_again) first = std::min(first, static_cast<std::int64_t>(i) + 1);
  }
  return std::max<std::int64_t>(first, 1);
}

/// "mode of failure" of "Mode of failure:,Barrel"; empty unless the line is one name and its value.
std::string name_of_pair(std::string_view line, Separator separator) {
  std::vector<std::string_view> cells = cells_of(line, separator);
  std::erase_if(cells, [](std::string_view cell) { return cell.empty(); });
  const bool is_one_cell = cells.size() == 1;
  if (cells.empty() || cells.size() > 2) return {};
  const auto colon = cells.front().find(':');
  const bool has_value = colon != std::string_view::npos && colon + 1 < cells.front().size();
  if (is_one_cell != has_value) return {};
  const std::string name = folded(cells.front().substr(0, colon));
  double number = 0;
  const bool is_number = parse_number_cell(name, {}, number) != CellKind::text;
  return is_number ? std::string() : name;
}

/// Number of the first lines below the rows of a test that are about it and not about the next
/// test: pairs of a name and a value whose name is not above the table.
std::size_t count_lines_of_foot(const TableLayout& layout, const std::vector<std::string>& lines) {
  std::vector<std::string> names;
  for (const std::string& line : layout.head)
    names.push_back(name_of_pair(line, layout.heading_separator));
  const auto is_of_foot = [&](const std::string& line) {
    const std::string name = name_of_pair(line, layout.heading_separator);
    return !name.empty() && std::ranges::find(names, name) == names.end();
  };
  return static_cast<std::size_t>(std::ranges::find_if_not(lines, is_of_foot) - lines.begin());
}

}  // namespace

void take_lines_below(TableLayout& layout, std::vector<std::string> lines) {
  constexpr std::size_t kMinCells = 3;  // fewer, and a row may have the form of a pair
  if (layout.cell_count < kMinCells) return;
  lines.resize(count_lines_of_foot(layout, lines));
  std::ranges::move(lines, std::back_inserter(layout.head));
}

void take_labels(TableLayout& layout) {
  layout.labels = labels_above(layout.head, layout.heading_separator, layout.beside);
  drop_keys(layout);
}

void take_labels_between(TableLayout& layout, std::vector<std::string> lines, std::int64_t line) {
  const std::size_t foot = count_lines_of_foot(layout, lines);
  lines.erase(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(foot));
  line += static_cast<std::int64_t>(foot);
  std::vector<LabelValue> labels = labels_above(lines, layout.heading_separator);
  if (labels.empty()) return;
  for (LabelValue& label : labels) label.line += line - 1;
  const std::int64_t own_line = first_own_line(layout, labels, lines);
  std::erase_if(layout.labels, [&](const LabelValue& common) {
    return common.line >= own_line ||
           std::ranges::find(labels, common.name, &LabelValue::name) != labels.end();
  });
  std::ranges::move(labels, std::back_inserter(layout.labels));
  layout.head.resize(std::min(layout.head.size(), static_cast<std::size_t>(own_line - 1)));
  std::ranges::move(lines, std::back_inserter(layout.head));
  drop_keys(layout);
}

TableLayout layout_of(const Dialect& dialect, const TableStructure& structure, std::size_t block,
                      const std::string& file, Findings& findings) {
  TableLayout out = layout_of_structure(structure, block, dialect, file);
  const std::size_t shift = shift_of(dialect, structure, block);
  out.labels = labels_above(structure, block);
  drop_keys(out);
  std::vector<bool> used(std::max(structure.column_count, structure.headings.size()));
  for (const DialectColumn& column : dialect.columns) {
    const auto cell = cell_of(column, structure, shift);
    if (!cell) continue;
    if (*cell >= used.size())
      throw BadInput(
          file, out.heading_line,
          fmt::format("the dialect names column {}, but the table has {}", *cell + 1, used.size()));
    PlannedColumn planned;
    planned.cell = *cell;
    planned.role = column.role;
    planned.quantity = column.quantity;
    planned.source = column.source;
    planned.heading = *cell < structure.headings.size() && !structure.headings[*cell].empty()
                          ? structure.headings[*cell]
                          : fmt::format("column {}", *cell + 1);
    planned.date_order = column.date_order;
    const bool is_time = column.role == ColumnRole::time || column.role == ColumnRole::stage_time;
    try {
      planned.scale = placed_scale(column, *cell, structure, file);
    } catch (const BadInput& error) {
      if (!is_time) throw;
      planned.unit_fault = error.what();
    }
    used[*cell] = true;
    out.columns.push_back(std::move(planned));
  }
  std::ranges::sort(out.columns, {}, &PlannedColumn::cell);
  for (std::size_t cell = 0; cell < used.size(); ++cell)
    if (!used[cell] && cell < structure.headings.size())
      note_unused(structure.headings[cell], out.heading_line, findings);
  return out;
}

TableLayout layout_of(const Proposal& proposal, const std::string& file, Findings& findings) {
  return Layout(proposal, file, findings).build();
}

}  // namespace triax::lab
