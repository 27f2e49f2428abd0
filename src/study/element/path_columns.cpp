// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/element/path_columns.hpp"

#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "sim/mechanics/units.hpp"

namespace triax::study {
namespace {

using enum sim::PathQuantity;

/// A column that is a quantity of the point.
struct QuantityColumn {
  std::string_view name;
  sim::PathQuantity quantity;
  int component = 0;
  bool in_kPa = false;
};
constexpr auto kQuantities = std::to_array<QuantityColumn>({
    {"axial_strain", axial_strain},
    {"radial_strain", radial_strain},
    {"volumetric_strain", volumetric_strain},
    {"shear_strain", shear_strain},
    {"p_eff_kPa", mean_effective_stress, 0, true},
    {"q_kPa", deviator_stress, 0, true},
    {"eta", stress_ratio},
    {"effective_axial_stress_kPa", effective_axial_stress, 0, true},
    {"effective_radial_stress_kPa", effective_radial_stress, 0, true},
    {"pore_pressure_kPa", pore_pressure, 0, true},
    {"void_ratio", void_ratio},
});
constexpr auto kComponents = std::to_array<QuantityColumn>({
    {"strain_11", strain_component, 0},
    {"strain_22", strain_component, 1},
    {"strain_33", strain_component, 2},
    {"strain_12", strain_component, 3},
    {"strain_13", strain_component, 4},
    {"strain_23", strain_component, 5},
    {"effective_stress_11_kPa", effective_stress_component, 0, true},
    {"effective_stress_22_kPa", effective_stress_component, 1, true},
    {"effective_stress_33_kPa", effective_stress_component, 2, true},
    {"effective_stress_12_kPa", effective_stress_component, 3, true},
    {"effective_stress_13_kPa", effective_stress_component, 4, true},
    {"effective_stress_23_kPa", effective_stress_component, 5, true},
});

template <class Space>
void put_quantities(const sim::PathPoint<Space>& at, std::span<const QuantityColumn> columns,
                    std::vector<std::optional<double>>& values) {
  static const sim::Unit kPa = *sim::find_unit("kPa");
  for (const QuantityColumn& column : columns) {
    auto value = finite(sim::value_of(column.quantity, column.component, at));
    if (value && column.in_kPa) value = sim::to_field(*value, kPa);
    values.push_back(value);
  }
}

}  // namespace

std::optional<double> finite(std::optional<double> value) {
  return value && std::isfinite(*value) ? value : std::nullopt;
}

template <class Space>
ResultPoint result_point(const sim::Path<Space>& path, const sim::PathPoint<Space>& at) {
  ResultPoint point;
  if (at.segment < path.segments.size()) point.segment = path.segments[at.segment].name;
  point.values.push_back(at.progress);
  put_quantities(at, kQuantities, point.values);
  point.values.push_back(finite(at.second_order_work));
  point.values.push_back(finite(at.determinant));
  if constexpr (Space::kSize == 6) put_quantities(at, kComponents, point.values);
  for (const double value : at.memory) point.values.push_back(finite(value));
  return point;
}

template <class Space>
std::vector<std::string> column_names(const sim::Law<Space>& law) {
  std::vector<std::string> names = {"progress"};
  for (const auto& column : kQuantities) names.emplace_back(column.name);
  names.insert(names.end(), {"second_order_work_normalised", "control_determinant"});
  if constexpr (Space::kSize == 6)
    for (const auto& column : kComponents) names.emplace_back(column.name);
  for (const auto& name : law.memory_names()) names.push_back("memory." + name);
  return names;
}

template std::vector<std::string> column_names(const sim::Law<sim::Axisymmetric>&);
template std::vector<std::string> column_names(const sim::Law<sim::Tensor>&);
template ResultPoint result_point(const sim::Path<sim::Axisymmetric>&,
                                  const sim::PathPoint<sim::Axisymmetric>&);
template ResultPoint result_point(const sim::Path<sim::Tensor>&,
                                  const sim::PathPoint<sim::Tensor>&);

}  // namespace triax::study
