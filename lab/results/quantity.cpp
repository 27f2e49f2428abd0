// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/quantity.hpp"

#include <array>

#include "sim/specimen/specimen_state.hpp"

namespace triax::lab {
namespace {

using enum Quantity;
using enum RawChannel::Zeroed;
using Specimen = sim::SpecimenState;

constexpr std::array<QuantityInfo, kQuantityCount> kTable{{
    {axial_displacement,
     "axial_displacement",
     "mm",
     "ΔH",
     {.sensor = "the axial displacement transducer",
      .standard = true,
      .in_state = true,
      .zeroed = joined,
      .drift_si = 0.02e-3,
      .absurd = 1e4}},
    {axial_force,
     "axial_force",
     "kN",
     "F",
     {.sensor = "the load cell",
      .spoken_unit = "N",
      .standard = true,
      .in_state = true,
      .zeroed = reported,
      .drift_si = 5,
      .absurd = 1e6}},
    {cell_pressure,
     "cell_pressure",
     "kPa",
     "σ_c",
     {.sensor = "the sensor of the cell pressure",
      .standard = true,
      .in_state = true,
      .held = true,
      .absurd = 1e6,
      .of_specimen = [](const Specimen& now, const Specimen&) { return now.cell_pressure; }}},
    {back_pressure,
     "back_pressure",
     "kPa",
     "u_b",
     {.sensor = "the sensor of the back pressure",
      .standard = true,
      .in_state = true,
      .held = true,
      .absurd = 1e6}},
    {pore_pressure,
     "pore_pressure",
     "kPa",
     "u",
     {.sensor = "the pore-pressure transducer",
      .standard = true,
      .in_state = true,
      .absurd = 1e6,
      .of_specimen = [](const Specimen& now, const Specimen&) { return now.pore_pressure; }}},
    {back_volume,
     "back_volume",
     "mm3",
     "V_b",
     {.sensor = "the volume gauge of the back-pressure controller",
      .standard = true,
      .in_state = true,
      .counts_water = true,
      .zeroed = joined,
      .drift_si = 20e-9,
      .absurd = 1e9}},
    {cell_volume,
     "cell_volume",
     "mm3",
     "V_c",
     {.sensor = "the volume gauge of the cell-pressure controller",
      .standard = true,
      .counts_water = true,
      .zeroed = joined,
      .drift_si = 20e-9,
      .absurd = 1e9}},
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
    {cycle, "cycle", "", "N"},
}};

static_assert(
    [] {
      for (std::size_t i = 0; i < kTable.size(); ++i)
        if (index(kTable[i].quantity) != i || kTable[i].name.empty()) return false;
      return true;
    }(),
    "one row a quantity, in the order of the enumeration");

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
