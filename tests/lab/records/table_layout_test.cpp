// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/table_layout.hpp"

#include <catch2/catch.hpp>
#include <string>

using namespace triax::lab;

namespace {

TableLayout layout_with(std::initializer_list<Quantity> columns) {
  TableLayout layout;
  for (const Quantity quantity : columns)
    layout.columns.push_back({.role = ColumnRole::quantity, .quantity = quantity});
  return layout;
}

void state(TableLayout& layout, const std::string& label, double value_kPa) {
  LabelValue stated;
  stated.name = label;
  stated.value = value_kPa;
  layout.labels.push_back(stated);
}

/// In kPa; -1 if the quantity is no constant.
double constant(const TableLayout& layout, Quantity quantity) {
  for (const RowConstant& one : layout.constants())
    if (one.quantity == quantity) return one.si / 1e3;
  return -1;
}

}  // namespace

TEST_CASE("TableLayout: a back pressure above the table is that beside Δu") {
  auto layout = layout_with({Quantity::deviator_stress, Quantity::excess_pore_pressure});
  CHECK(layout.constants().empty());
  state(layout, "back_pressure", 300);
  CHECK(constant(layout, Quantity::back_pressure) == Approx(300));
  layout.dialect.constants.push_back({Quantity::back_pressure, 2e5});
  CHECK(constant(layout, Quantity::back_pressure) == Approx(200));  // the dialect is stronger
  CHECK(layout.constants().size() == 1);
}

TEST_CASE("TableLayout: a back pressure is the pore pressure only of a drained type") {
  auto layout = layout_with({Quantity::deviator_stress, Quantity::volumetric_strain});
  state(layout, "back_pressure", 300);
  CHECK(layout.constants().empty());  // an undrained test has a column of zeros, too
  LabelValue type;
  type.name = "programme";
  type.text = "CIU";
  layout.labels.push_back(type);
  CHECK(layout.constants().empty());
  layout.labels.back().text = "CID";
  CHECK(constant(layout, Quantity::pore_pressure) == Approx(300));
}

TEST_CASE("TableLayout: an effective consolidation stress stands for both pressures") {
  auto layout = layout_with({Quantity::deviator_stress, Quantity::excess_pore_pressure});
  state(layout, "effective_consolidation_stress", 49);
  CHECK(constant(layout, Quantity::cell_pressure) == Approx(49));
  CHECK(constant(layout, Quantity::back_pressure) == Approx(0));
  state(layout, "cell_pressure", 349);
  CHECK(layout.constants().empty());
  auto known = layout_with({Quantity::mean_effective_stress, Quantity::excess_pore_pressure});
  state(known, "effective_consolidation_stress", 49);
  CHECK(known.constants().empty());
}

TEST_CASE("TableLayout: an ambiguous label states nothing") {
  auto layout = layout_with({Quantity::deviator_stress, Quantity::excess_pore_pressure});
  state(layout, "back_pressure", 300);
  layout.labels.front().is_ambiguous = true;
  CHECK(layout.constants().empty());
}
