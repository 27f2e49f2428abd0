// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/column_consistency.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "lab/base/text.hpp"

namespace triax::lab {

/// left = formula(others); `start` are the values of index 0.
struct ColumnConsistency::Relation {
  using Values = std::array<PrintedValue, kQuantityCount>;
  Quantity left;
  std::vector<Quantity> others;
  std::vector<Quantity> unless;  ///< with one of these columns another relation says the same
  const char* formula;
  PrintedValue (*right)(const Values& now, const Values& start);
  bool from_start = false;  ///< needs values of index 0; a left side of zero may set them
};

namespace {

using enum Quantity;
constexpr std::string_view kStressUnit = "kPa";
using Values = std::array<PrintedValue, kQuantityCount>;

const PrintedValue& value_in(const Values& values, Quantity quantity) {
  return values[index(quantity)];
}

/// The small-strain value, with the distance to the other definition of the strain as an error.
PrintedValue either(PrintedValue small, double other) {
  small.error += std::fabs(small.value - other);
  return small;
}

PrintedValue volume_of_strains(const Values& now, const Values&) {
  const auto &axial = value_in(now, axial_strain), &radial = value_in(now, radial_strain);
  const double shortened = (1 - axial.value) * (1 - radial.value) * (1 - radial.value);
  return either(axial + 2 * radial, 1 - shortened);
}

PrintedValue shear_of_volume(const Values& now, const Values&) {
  const auto &axial = value_in(now, axial_strain), &volume = value_in(now, volumetric_strain);
  // 2(ε₁ − ε₃)/3 with the ε₃ of a right cylinder of the present dimensions
  const double radial = 1 - std::sqrt((1 - volume.value) / (1 - axial.value));
  return either(axial - (1.0 / 3) * volume, 2 * (axial.value - radial) / 3);
}

PrintedValue volume_of_voids(const Values& now, const Values& start) {
  const auto &e = value_in(now, void_ratio), &e_start = value_in(start, void_ratio);
  const auto& volume_start = value_in(start, volumetric_strain);
  const double ratio = (1 - volume_start.value) / (1 + e_start.value);
  const double lost = 1 - (1 + e.value) * ratio;
  const double error = e.error * ratio + (1 + e.value) * ratio *
                                             (volume_start.error / (1 - volume_start.value) +
                                              e_start.error / (1 + e_start.value));
  return either({lost, error}, -std::log1p(-lost));
}

PrintedValue excess_of_pressure(const Values& now, const Values& start) {
  return value_in(now, pore_pressure) - value_in(start, pore_pressure) +
         value_in(start, excess_pore_pressure);
}

}  // namespace

const std::vector<ColumnConsistency::Relation>& ColumnConsistency::all_relations() {
  using V = const Values&;
  constexpr double kThird = 1.0 / 3;
  static const std::vector<Relation> relations{
      {deviator_stress,
       {effective_axial_stress, effective_radial_stress},
       {},
       "σ₁′ − σ₃′",
       [](V now, V) {
         return value_in(now, effective_axial_stress) - value_in(now, effective_radial_stress);
       }},
      {deviator_stress,
       {axial_stress, radial_stress},
       {},
       "σ₁ − σ₃",
       [](V now, V) { return value_in(now, axial_stress) - value_in(now, radial_stress); }},
      {deviator_stress,
       {axial_stress, cell_pressure},
       {radial_stress},
       "σ₁ − σ_c",
       [](V now, V) { return value_in(now, axial_stress) - value_in(now, cell_pressure); }},
      {deviator_stress,
       {stress_ratio, mean_effective_stress},
       {},
       "η p′",
       [](V now, V) { return value_in(now, stress_ratio) * value_in(now, mean_effective_stress); }},
      {mean_effective_stress,
       {effective_axial_stress, effective_radial_stress},
       {},
       "(σ₁′ + 2σ₃′)/3",
       [](V now, V) {
         return kThird * (value_in(now, effective_axial_stress) +
                          2 * value_in(now, effective_radial_stress));
       }},
      {mean_effective_stress,
       {effective_radial_stress, deviator_stress},
       {effective_axial_stress},
       "σ₃′ + q/3",
       [](V now, V) {
         return value_in(now, effective_radial_stress) + kThird * value_in(now, deviator_stress);
       }},
      {mean_effective_stress,
       {effective_axial_stress, deviator_stress},
       {effective_radial_stress},
       "σ₁′ − 2q/3",
       [](V now, V) {
         return value_in(now, effective_axial_stress) - 2 * kThird * value_in(now, deviator_stress);
       }},
      {effective_axial_stress,
       {axial_stress, pore_pressure},
       {},
       "σ₁ − u",
       [](V now, V) { return value_in(now, axial_stress) - value_in(now, pore_pressure); }},
      {effective_radial_stress,
       {radial_stress, pore_pressure},
       {},
       "σ₃ − u",
       [](V now, V) { return value_in(now, radial_stress) - value_in(now, pore_pressure); }},
      {effective_radial_stress,
       {cell_pressure, pore_pressure},
       {radial_stress},
       "σ_c − u",
       [](V now, V) { return value_in(now, cell_pressure) - value_in(now, pore_pressure); }},
      {radial_stress,
       {cell_pressure},
       {},
       "σ_c",
       [](V now, V) { return value_in(now, cell_pressure); }},
      {volumetric_strain, {axial_strain, radial_strain}, {}, "ε₁ + 2ε₃", volume_of_strains},
      {shear_strain, {axial_strain, volumetric_strain}, {}, "ε₁ − ε_v/3", shear_of_volume},
      {shear_strain,
       {axial_strain, radial_strain},
       {volumetric_strain},
       "2(ε₁ − ε₃)/3",
       [](V now, V) {
         return 2 * kThird * (value_in(now, axial_strain) - value_in(now, radial_strain));
       }},
      {volumetric_strain, {void_ratio}, {}, "that of the void ratio", volume_of_voids, true},
      {excess_pore_pressure, {pore_pressure}, {}, "u − u₀", excess_of_pressure, true},
  };
  return relations;
}

ColumnConsistency::ColumnConsistency(const TableLayout& layout) : layout_(layout) {
  std::array<bool, kQuantityCount> there{};
  for (const Quantity quantity : layout.quantities()) there[index(quantity)] = true;
  const auto is_there = [&](Quantity quantity) { return there[index(quantity)]; };
  for (const Relation& relation : all_relations()) {
    if (!is_there(relation.left) || !std::ranges::all_of(relation.others, is_there) ||
        std::ranges::any_of(relation.unless, is_there))
      continue;
    relations_.push_back(&relation);
    needed_[index(relation.left)] = true;
    for (const Quantity other : relation.others) needed_[index(other)] = true;
  }
  for (const QuantityInfo& row : quantities())
    if (needs(row.quantity) && row.unit == kStressUnit) stresses_.push_back(row.quantity);
}

void ColumnConsistency::add(const Cells& row, double stage, std::int64_t line, Findings& findings) {
  if (!std::isnan(stage) && stage != stage_) {
    start_ = {};
    stage_ = stage;
  }
  double largest_stress = 0;
  for (const Quantity quantity : stresses_)
    largest_stress = std::fmax(largest_stress, std::fabs(value_in(row, quantity).value));
  for (const Relation* relation : relations_) {
    const bool is_stress = info(relation->left).unit == kStressUnit;
    compare(*relation, row, is_stress ? largest_stress : 1, line, findings);
  }
}

void ColumnConsistency::compare(const Relation& relation, const Cells& row, double scale,
                                std::int64_t line, Findings& findings) {
  const PrintedValue& left = value_in(row, relation.left);
  if (std::isnan(left.value)) return;
  const auto begin_here = [&] {
    start_[index(relation.left)] = left;
    for (const Quantity other : relation.others) start_[index(other)] = value_in(row, other);
  };
  if (relation.from_start && std::isnan(value_in(start_, relation.left).value)) begin_here();
  const PrintedValue right = relation.right(row, start_);
  if (!left.contradicts(right, scale)) return;
  if (relation.from_start && std::fabs(left.value) <= left.error) {
    begin_here();
    return;
  }
  findings.note(std::string("contradiction ") + relation.formula, line, [&] {
    const PlannedColumn& column = column_of(relation.left);
    std::vector<std::string> names;
    for (const Quantity other : relation.others) names.push_back(excerpt(column_of(other).heading));
    return fmt::format(
        "column {} has {:.6g}, but {} from {} is {:.6g}: the columns contradict "
        "each other by more than their printed digits allow",
        excerpt(column.heading), left.value / column.scale, relation.formula,
        joined(names, " and "), right.value / column.scale);
  });
}

const PlannedColumn& ColumnConsistency::column_of(Quantity quantity) const {
  return *std::ranges::find_if(layout_.columns, [&](const PlannedColumn& column) {
    return column.role == ColumnRole::quantity && column.quantity == quantity;
  });
}

}  // namespace triax::lab
