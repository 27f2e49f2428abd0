// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/column_plan.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/intake/names/record_units.hpp"
#include "lab/intake/names/unit_names.hpp"
#include "lab/records/metadata.hpp"

namespace triax::lab {
namespace {

using Cells = std::vector<std::string_view>;

// How a heading fits a dialect: the column, which synonym, and the unit its text holds.
struct Fit {
  std::size_t synonym = 0;
  std::optional<std::string> unit;
};

std::optional<Fit> fit(const DialectColumn& column, std::string_view heading) {
  if (std::ranges::none_of(column.names,
                           [&](const auto& name) { return may_match(heading, name); }))
    return std::nullopt;
  const auto parts = split_heading(heading);
  const auto tail = split_unit(heading);
  for (std::size_t i = 0; i < column.names.size(); ++i) {
    const auto& name = column.names[i];
    if (matches_name(heading, name) || matches_name(parts.name, name)) return Fit{i, parts.unit};
    if (tail && matches_name(tail->name, name)) return Fit{i, std::string(tail->unit.name)};
  }
  return std::nullopt;
}

// A heading in triax's own form: "cell_pressure_kPa", "axial_strain", "axial_strain (%)".
std::optional<std::pair<Quantity, std::string>> own_heading(std::string_view heading) {
  const bool word = !heading.empty() && static_cast<unsigned char>(heading.front()) > '9';
  if (!word) return std::nullopt;
  const auto parts = split_heading(heading);
  const auto name = folded(parts.name);
  if (const auto quantity = find_quantity(name))
    return std::pair(*quantity, parts.unit.value_or(""));
  if (parts.unit) return std::nullopt;
  for (auto at = name.rfind('_'); at != std::string::npos && at > 0; at = name.rfind('_', at - 1))
    if (const auto quantity = find_quantity(name.substr(0, at)))
      return std::pair(*quantity, std::string(trimmed(heading).substr(at + 1)));
  return std::nullopt;
}

class Planner {
 public:
  Planner(TableLayout& layout, std::string_view heading_line, Findings& findings)
      : layout_(layout), findings_(findings) {
    split_cells(heading_line, layout.heading_separator, cells_);
    while (!cells_.empty() && cells_.back().empty()) cells_.pop_back();
    layout.cell_count = cells_.size();
    taken_.assign(cells_.size(), false);
  }

  void plan(const std::vector<std::optional<std::string>>& units) {
    units_ = units;
    for (const DialectColumn& column : layout_.dialect.columns) plan_named(column);
    if (layout_.dialect.own_headings) plan_own();
    std::ranges::sort(layout_.columns, {}, &PlannedColumn::cell);
  }
  const std::vector<std::string>& unknown() const { return unknown_; }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw BadInput(layout_.file, layout_.heading_line, message);
  }

  void plan_placed(const DialectColumn& column) {
    const std::size_t cell = column.position - 1;
    if (cell >= cells_.size())
      fail(fmt::format("the dialect names column {}, but the headings have {}", column.position,
                       cells_.size()));
    add(cell, column, split_heading(cells_[cell]).unit);
  }

  void plan_named(const DialectColumn& column) {
    if (column.position > 0) return plan_placed(column);
    std::optional<Fit> chosen;
    std::size_t cell = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (taken_[i] || cells_[i].empty()) continue;
      const auto found = fit(column, cells_[i]);
      if (!found) continue;
      if (chosen && chosen->synonym == found->synonym) two_columns(cell, i);
      if (chosen && chosen->synonym < found->synonym) continue;
      chosen = found;
      cell = i;
    }
    if (chosen) add(cell, column, chosen->unit);
  }

  void plan_own() {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (taken_[i] || cells_[i].empty()) continue;
      const auto own = own_heading(cells_[i]);
      if (!own) {
        leave_out(cells_[i]);
        continue;
      }
      for (const PlannedColumn& other : layout_.columns)
        if (other.role == ColumnRole::quantity && other.quantity == own->first)
          two_columns(other.cell, i);
      DialectColumn column;
      column.quantity = own->first;
      add(i, column, own->second.empty() ? std::nullopt : std::optional(own->second));
    }
  }

  void leave_out(std::string_view heading) {
    for (const PlannedColumn& other : layout_.columns)
      if (folded(other.heading) == folded(heading)) two_columns(other.cell, other.cell);
    std::vector<std::string> known{"time_s", "stage"};
    for (const QuantityInfo& row : quantities()) known.push_back(lab::heading(row.quantity));
    const auto near = nearest(heading, known);
    unknown_.push_back(fmt::format("unknown column {} is ignored{}", excerpt(heading),
                                   near.empty() ? "" : "; did you mean '" + near + "'?"));
    findings_.note("unknown column " + std::string(heading), layout_.heading_line, unknown_.back());
  }

  [[noreturn]] void two_columns(std::size_t a, std::size_t b) const {
    fail(fmt::format("two columns are the same: {} (column {}) and {} (column {}); keep one",
                     excerpt(cells_[a]), a + 1, excerpt(cells_[b]), b + 1));
  }

  void add(std::size_t cell, const DialectColumn& column,
           const std::optional<std::string>& heading_unit) {
    PlannedColumn planned;
    planned.cell = cell;
    planned.role = column.role;
    planned.quantity = column.quantity;
    planned.source = column.source;
    planned.heading = cells_[cell];
    planned.date_order = column.date_order;
    set_scale(planned, column, heading_unit);
    taken_[cell] = true;
    layout_.columns.push_back(std::move(planned));
  }

  static std::string_view unit_of(const DialectColumn& column) {
    if (column.role == ColumnRole::quantity) return info(column.quantity).unit;
    if (column.role == ColumnRole::source) return source_quantities()[index(column.source)].unit;
    return "s";
  }
  static bool is_unit(const std::string& text) {
    return sim::find_unit(text) || !find_unit_names(text).empty();
  }

  /// A time may be a clock, which has no unit.
  void set_scale(PlannedColumn& planned, const DialectColumn& column,
                 const std::optional<std::string>& heading_unit) const {
    const bool is_time = column.role == ColumnRole::time || column.role == ColumnRole::stage_time;
    try {
      planned.scale = column.sign * column.factor * scale(planned.cell, column, heading_unit);
    } catch (const BadInput& error) {
      if (!is_time) throw;
      planned.unit_fault = error.what();
    }
  }

  double scale(std::size_t cell, const DialectColumn& column,
               const std::optional<std::string>& heading_unit) const {
    if (column.role == ColumnRole::stage || column.role == ColumnRole::test ||
        column.role == ColumnRole::date || column.role == ColumnRole::time_of_day)
      return 1;
    const std::string wanted(unit_of(column));
    const auto dimension = sim::find_unit(wanted)->dimension;
    std::optional<std::string> text;
    if (!column.true_unit.empty())
      text = column.true_unit;
    else if (heading_unit)
      text = heading_unit;
    else if (cell < units_.size() && units_[cell])
      text = units_[cell];
    else if (!column.unit.empty())
      text = column.unit;
    const auto name = std::string(cells_[cell]);
    if (!text) {
      if (wanted.empty()) return 1;
      fail(fmt::format("column {} has no unit; write {}_{} or another unit of this quantity",
                       excerpt(name), name, wanted));
    }
    const auto unit = find_record_unit(*text, dimension);
    if (!unit)
      fail(
          fmt::format("column {} is in {}, {}; known: {}. If the heading is wrong, a dialect gives "
                      "the right one: true_unit = \"{}\"",
                      excerpt(name), excerpt(*text),
                      is_unit(*text) ? "which does not fit this quantity" : "an unknown unit",
                      record_unit_names(dimension), wanted));
    return unit->scale;
  }

  TableLayout& layout_;
  Findings& findings_;
  Cells cells_;
  std::vector<bool> taken_;
  std::vector<std::optional<std::string>> units_;
  std::vector<std::string> unknown_;
};

}  // namespace

HeadingParts split_heading(std::string_view heading) {
  heading = trimmed(heading);
  const char close = heading.empty() ? ' ' : heading.back();
  if (close == ')' || close == ']') {
    const auto open = heading.rfind(close == ')' ? '(' : '[');
    if (open != std::string_view::npos && open > 0)
      return {std::string(trimmed(heading.substr(0, open))),
              std::string(trimmed(heading.substr(open + 1, heading.size() - open - 2)))};
  }
  return {std::string(heading), std::nullopt};
}

std::size_t count_known(const Dialect& dialect, const std::vector<std::string_view>& cells) {
  std::size_t known = 0;
  for (const auto cell : cells) {
    if (cell.empty()) continue;
    const bool named = std::ranges::any_of(
        dialect.columns, [&](const auto& column) { return fit(column, cell).has_value(); });
    if (named || (dialect.own_headings && own_heading(cell))) ++known;
  }
  return known;
}

bool has_own_heading(const std::vector<std::string_view>& cells) {
  return std::ranges::any_of(
      cells, [](std::string_view cell) { return !cell.empty() && own_heading(cell).has_value(); });
}

std::vector<std::string> plan_columns(TableLayout& layout, std::string_view heading_line,
                                      const std::vector<std::optional<std::string>>& units,
                                      Findings& findings) {
  Planner planner(layout, heading_line, findings);
  planner.plan(units);
  return planner.unknown();
}

}  // namespace triax::lab
