// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/diggs_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/diggs/data_values.hpp"
#include "lab/diggs/diggs_units.hpp"
#include "lab/results/reading.hpp"

namespace triax::lab {
namespace {

using Role = DiggsColumn::Role;

/// A cell in the unit of its column; NaN where it is missing.
class CellReader {
 public:
  CellReader(const DiggsColumn& column, std::string_view uom, std::string what)
      : to_(column.unit()), what_(std::move(what)), uom_(uom) {}

  double read(std::string_view text, const std::string& file, std::int64_t line) {
    if (!from_) from_ = unit_of_file(file, line);
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    if (text.empty() || folded(text) == "nan") return kMissing;
    const auto number = whole_text_as<double>(text);
    if (!number || !std::isfinite(*number))
      throw BadInput(file, line, fmt::format("{} = {} is not a number", what_, excerpt(text)));
    if (from_->name == to_.name) return *number;
    return sim::to_field(sim::to_si(*number, *from_), to_);
  }

 private:
  sim::Unit unit_of_file(const std::string& file, std::int64_t line) const {
    const auto unit = find_diggs_unit(uom_);
    if (!unit)
      throw BadInput(file, line,
                     fmt::format("{} is in {}, an unknown unit of measure; expected a unit like {}",
                                 what_, excerpt(uom_), to_.name.empty() ? "%" : to_.name));
    if (unit->dimension != to_.dimension)
      throw BadInput(
          file, line,
          fmt::format("{} is in {}; expected a unit like {}", what_,
                      uom_.empty() ? "no unit" : excerpt(uom_), to_.name.empty() ? "%" : to_.name));
    return *unit;
  }

  sim::Unit to_;
  std::string what_, uom_;
  std::optional<sim::Unit> from_;
};

void append_row(DiggsTable& table, const std::vector<double>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) table.rows += ',';
    if (!std::isnan(cells[i])) fmt::format_to(std::back_inserter(table.rows), "{}", cells[i]);
  }
  table.rows += '\n';
  ++table.count;
}

bool holds_readings(const std::vector<DiggsColumn>& columns) {
  const auto any = [&](std::initializer_list<Quantity> wanted) {
    return std::ranges::any_of(columns, [&](const DiggsColumn& column) {
      return column.role == Role::quantity &&
             std::ranges::find(wanted, column.quantity) != wanted.end();
    });
  };
  return any({Quantity::axial_displacement, Quantity::axial_strain, Quantity::shear_strain}) &&
         any({Quantity::axial_force, Quantity::deviator_stress, Quantity::axial_stress,
              Quantity::effective_axial_stress, Quantity::mean_effective_stress});
}

std::string label_of(const DiggsProperty& property) {
  return excerpt(property.name.empty() ? property.property_class : property.name);
}

/// A unit that records know is kept: cells then keep their digits.
DiggsColumn in_unit_of_file(DiggsColumn column, std::string_view uom) {
  const auto unit = sim::find_unit(trimmed(uom));
  if (unit && !unit->name.empty() && unit->dimension == column.unit().dimension &&
      column.role != Role::stage)
    column.file_unit = unit;
  return column;
}

/// A column of a set: where its cells are, and how they are read.
struct SetColumn {
  std::size_t cell = 0;
  CellReader reader;
};

DiggsTable read_set(const DiggsResultSet& set, const std::string& file) {
  DiggsTable table;
  std::vector<SetColumn> cells;
  std::vector<std::string> unused;
  for (std::size_t i = 0; i < set.properties.size(); ++i) {
    const DiggsProperty& property = set.properties[i];
    const auto column = find_diggs_column(property.property_class, property.name);
    const bool is_new = column && std::ranges::none_of(table.columns, [&](const DiggsColumn& one) {
                          return one.is_same(*column);
                        });
    if (!is_new) {
      unused.push_back(label_of(property));
      continue;
    }
    table.columns.push_back(in_unit_of_file(*column, property.uom));
    cells.push_back(
        {i, CellReader(table.columns.back(), property.uom, "property " + label_of(property))});
  }
  if (!holds_readings(table.columns)) return {};
  const auto tuples = split_data_values(set, file);
  if (tuples.size() < 2) return {};
  std::vector<double> row(cells.size());
  for (const DiggsTuple& tuple : tuples) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      std::string text(tuple.cells[cells[i].cell]);
      if (set.decimal_mark == ",") std::ranges::replace(text, ',', '.');
      const auto& null_value = set.properties[cells[i].cell].null_value;
      const bool is_null = !null_value.empty() && text == null_value;
      row[i] = cells[i].reader.read(is_null ? "" : text, file, tuple.line);
    }
    append_row(table, row);
  }
  constexpr std::size_t kMaxNamed = 10;
  if (unused.size() > kMaxNamed) {
    unused.resize(kMaxNamed);
    unused.emplace_back("...");
  }
  if (!unused.empty())
    table.warnings.push_back({set.line, "properties that are not used: " + joined(unused)});
  return table;
}

/// Places in kIncrementElements.
enum Element : std::size_t {
  kLoad,
  kDeflection,
  kDeviator,
  kStrain,
  kTime,
  kInduced,
  kTotal,
  kCell,
  kElements
};

DiggsColumn quantity_column(Quantity quantity) { return {.quantity = quantity}; }

const std::array<DiggsColumn, kElements>& element_columns() {
  static const std::array<DiggsColumn, kElements> columns{
      quantity_column(Quantity::axial_force),
      quantity_column(Quantity::axial_displacement),
      quantity_column(Quantity::deviator_stress),
      quantity_column(Quantity::axial_strain),
      DiggsColumn{.role = Role::time},
      quantity_column(Quantity::excess_pore_pressure),
      quantity_column(Quantity::pore_pressure),
      quantity_column(Quantity::cell_pressure)};
  return columns;
}

using IncrementRow = std::array<double, kElements>;

IncrementRow read_increment(const DiggsIncrement& increment, const std::string& file) {
  IncrementRow row{};
  for (std::size_t i = 0; i < kElements; ++i) {
    const DiggsValue& value = increment.values[i];
    row[i] = value.text.empty()
                 ? kMissing
                 : CellReader(element_columns()[i], value.uom, std::string(kIncrementElements[i]))
                       .read(value.text, file, value.line);
  }
  return row;
}

/// A pressure of a stage in kPa; NaN where the file does not have it.
double pressure_of(const DiggsTrial& trial, std::string_view name, const std::string& file) {
  const auto found = trial.values.find(name);
  if (found == trial.values.end()) return kMissing;
  return CellReader(quantity_column(Quantity::cell_pressure), found->second.uom, std::string(name))
      .read(found->second.text, file, found->second.line);
}

bool any_has(const std::vector<IncrementRow>& rows, Element element) {
  return std::ranges::any_of(rows, [=](const auto& row) { return !std::isnan(row[element]); });
}

void complete_cell_pressure(std::vector<IncrementRow>& rows, double of_stage, std::int64_t line,
                            std::vector<Warning>& warnings) {
  double last = of_stage;
  bool carried = false;
  for (IncrementRow& row : rows) {
    carried = carried || (std::isnan(row[kCell]) && !std::isnan(last) && std::isnan(of_stage));
    if (!std::isnan(row[kCell]))
      last = row[kCell];
    else
      row[kCell] = last;
  }
  if (carried)
    warnings.push_back({line,
                        "totalCellPressure is missing in some increments; the one before it is "
                        "used, as if the cell pressure was constant"});
}

void complete_pore_pressure(std::vector<IncrementRow>& rows, double at_start) {
  for (IncrementRow& row : rows)
    if (std::isnan(row[kTotal])) row[kTotal] = at_start + row[kInduced];
}

void write_rows(DiggsTable& table, const std::vector<IncrementRow>& rows) {
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < kElements; ++i) {
    const auto element = static_cast<Element>(i);
    // The induced pore pressure follows from the total one.
    if (!any_has(rows, element) || (element == kInduced && any_has(rows, kTotal))) continue;
    used.push_back(i);
    table.columns.push_back(element_columns()[i]);
  }
  std::vector<double> cells(used.size());
  for (const IncrementRow& row : rows) {
    std::ranges::transform(used, cells.begin(), [&](std::size_t i) { return row[i]; });
    append_row(table, cells);
  }
}

}  // namespace

bool DiggsTable::has(Quantity quantity) const {
  return std::ranges::any_of(columns, [=](const DiggsColumn& column) {
    return column.role == Role::quantity && column.quantity == quantity;
  });
}

bool DiggsTable::has_stages() const {
  return std::ranges::any_of(columns,
                             [](const DiggsColumn& column) { return column.role == Role::stage; });
}

std::string DiggsTable::text() const {
  std::vector<std::string> headings;
  headings.reserve(columns.size());
  for (const DiggsColumn& column : columns) headings.push_back(column.heading());
  return joined(headings, ",") + '\n' + rows;
}

DiggsTable read_result_sets(const DiggsTest& test, const std::string& file) {
  for (const DiggsResultSet& set : test.result_sets)
    if (auto table = read_set(set, file); table.count > 0) return table;
  return {};
}

DiggsTable read_increments(const DiggsTrial& trial, const std::string& file) {
  DiggsTable table;
  if (trial.shearing.empty()) return table;
  std::vector<IncrementRow> rows;
  rows.reserve(trial.shearing.size());
  for (const DiggsIncrement& increment : trial.shearing)
    rows.push_back(read_increment(increment, file));
  const auto line = trial.shearing.front().line;
  complete_cell_pressure(rows, pressure_of(trial, "totalCellPressureDuringShearStage", file), line,
                         table.warnings);
  double start = pressure_of(trial, "porewaterPressureStartOfShearing", file);
  if (std::isnan(start) && any_has(rows, kInduced) && !any_has(rows, kTotal)) {
    start = pressure_of(trial, "maximumBackPressureApplied", file);
    if (!std::isnan(start))
      table.warnings.push_back({line,
                                "porewaterPressureStartOfShearing is missing; "
                                "maximumBackPressureApplied is used for it"});
  }
  complete_pore_pressure(rows, start);
  write_rows(table, rows);
  if (trial.other_increments > 0)
    table.warnings.push_back(
        {trial.line, fmt::format("{} increments of saturation and consolidation are not used: "
                                 "they have no stresses",
                                 trial.other_increments)});
  return table;
}

}  // namespace triax::lab
