#include "lab/results/quantity.hpp"

#include <array>

namespace triax::lab {
namespace {

using enum Quantity;

constexpr std::array<QuantityInfo, kQuantityCount> kTable{{
    {axial_displacement, "axial_displacement", "mm", "ΔH"},
    {axial_force, "axial_force", "kN", "F"},
    {cell_pressure, "cell_pressure", "kPa", "σ_c"},
    {back_pressure, "back_pressure", "kPa", "u_b"},
    {pore_pressure, "pore_pressure", "kPa", "u"},
    {back_volume, "back_volume", "mm3", "V_b"},
    {cell_volume, "cell_volume", "mm3", "V_c"},
    {axial_strain, "axial_strain", "", "ε₁"},
    {radial_strain, "radial_strain", "", "ε₃"},
    {volumetric_strain, "volumetric_strain", "", "ε_v"},
    {shear_strain, "shear_strain", "", "ε_q"},
    {axial_stress, "axial_stress", "kPa", "σ₁"},
    {radial_stress, "radial_stress", "kPa", "σ₃"},
    {effective_axial_stress, "effective_axial_stress", "kPa", "σ₁′"},
    {effective_radial_stress, "effective_radial_stress", "kPa", "σ₃′"},
    {deviator_stress, "deviator_stress", "kPa", "q"},
    {mean_effective_stress, "mean_effective_stress", "kPa", "p′"},
    {stress_ratio, "stress_ratio", "", "η"},
    {excess_pore_pressure, "excess_pore_pressure", "kPa", "Δu"},
    {void_ratio, "void_ratio", "", "e"},
    {current_area, "current_area", "mm2", "A"},
}};

}  // namespace

std::span<const QuantityInfo> quantities() { return kTable; }

const QuantityInfo& info(Quantity quantity) { return kTable[index(quantity)]; }

std::string heading(Quantity quantity) {
  const QuantityInfo& row = info(quantity);
  std::string text(row.name);
  if (!row.unit.empty()) text.append("_").append(row.unit);
  return text;
}

std::optional<Quantity> find_quantity(std::string_view name) {
  for (const QuantityInfo& row : kTable)
    if (row.name == name) return row.quantity;
  return std::nullopt;
}

}  // namespace triax::lab
