// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/table_layout.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "lab/results/test_type.hpp"

namespace triax::lab {

bool TableLayout::has(ColumnRole role) const {
  return std::ranges::any_of(columns, [&](const PlannedColumn& column) {
    const bool is_clock = column.role == ColumnRole::date || column.role == ColumnRole::time_of_day;
    return column.role == role || (role == ColumnRole::time && is_clock);
  });
}

bool TableLayout::has(Quantity quantity) const {
  return std::ranges::any_of(columns,
                             [&](const PlannedColumn& column) {
                               return column.role == ColumnRole::quantity &&
                                      column.quantity == quantity;
                             }) ||
         std::ranges::find(dialect.constants, quantity, &RowConstant::quantity) !=
             dialect.constants.end();
}

std::vector<RowConstant> TableLayout::constants() const {
  using enum Quantity;
  auto out = dialect.constants;
  const auto has_any = [&](std::initializer_list<Quantity> all) {
    return std::ranges::any_of(all, [&](Quantity one) { return has(one); });
  };
  const auto stated = [&](std::string_view name) -> std::optional<double> {
    constexpr double kKilo = 1e3;
    const auto label = std::ranges::find(labels, name, &LabelValue::name);
    if (label == labels.end() || label->is_ambiguous || !label->value) return std::nullopt;
    return *label->value * kKilo;
  };
  if (has_any({pore_pressure, back_pressure, effective_axial_stress, effective_radial_stress,
               mean_effective_stress}))
    return out;
  const auto type = std::ranges::find(labels, "programme", &LabelValue::name);
  const TestType* const known = type == labels.end() ? nullptr : find_test_type(type->text);
  if (!has(excess_pore_pressure) && !(known && known->drained)) return out;
  const Quantity second = has(excess_pore_pressure) ? back_pressure : pore_pressure;
  const bool has_cell = has_any({cell_pressure, radial_stress, axial_stress});
  if (const auto back = stated("back_pressure")) {
    out.push_back({second, *back});
  } else if (const auto effective = stated("effective_consolidation_stress");
             effective && !has_cell && !stated("cell_pressure")) {
    out.push_back({cell_pressure, *effective});
    out.push_back({second, 0});
  }
  return out;
}

RowCompletion TableLayout::completion() const {
  std::vector<Quantity> measured;
  std::vector<SourceQuantity> sources;
  for (const PlannedColumn& column : columns) {
    if (column.role == ColumnRole::quantity) measured.push_back(column.quantity);
    if (column.role == ColumnRole::source) sources.push_back(column.source);
  }
  return {std::move(measured), sources, constants()};
}

std::vector<Quantity> TableLayout::quantities() const { return completion().quantities(); }

}  // namespace triax::lab
