// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where things stand in the workbook of a test, so that formulas of one sheet find those of
// another. Rows count from 0 here, from 1 in an address.
#include <cstddef>
#include <cstdint>
#include <string>

#include "src/export/workbook/term.hpp"

namespace triax::src {

inline constexpr const char* kSpecimenSheet = "specimen";
inline constexpr const char* kStagesSheet = "stages";
inline constexpr const char* kReadingsSheet = "readings";
inline constexpr const char* kStatesSheet = "states";
inline constexpr const char* kBlocksSheet = "blocks";
inline constexpr const char* kVerdictSheet = "verdict";
inline constexpr const char* kChartsSheet = "charts";

/// Title of the sheet, headings, then rows. The readings' headings stand below the metadata of
/// their record (ReadingsSheet).
inline constexpr std::size_t kTitleRow = 0, kHeadingRow = 1, kFirstRow = 2;

/// Columns of the states behind those of study::columns_handed_over().
enum class StateCell : std::uint8_t {
  work_normalised,
  work_error,
  window_readings,
  shortening_m,
  outflow_m3,
  area_m2,
  q_measured_pa,
  membrane_axial_pa,
  membrane_radial_pa,
  pore_pressure_pa,
  axial_pa,
  radial_pa,
  q_pa,
  p_eff_pa,
  specimen_volumetric_strain,
  axial_strain_path,
  progress_of_block,
  q_rate,
  p_rate,
  axial_rate,
  volumetric_rate,
  axial_stress_rate,
  radial_stress_rate,
  radial_strain_rate,
  work,
};
inline constexpr std::size_t kStateCells = static_cast<std::size_t>(StateCell::work) + 1;

/// Columns of a reference on the stages' sheet: the dimensions from which strains count.
enum class ReferenceCell : std::uint8_t {
  from_reading,
  stage,
  height_m,
  volume_m3,
  area_m2,
  displacement_m,
  back_volume_m3,
  void_ratio,
  membrane_pa,
  how,
};

inline std::string on_sheet(const char* sheet, std::size_t column, std::size_t row) {
  return std::string(sheet) + '!' + address(column, row + 1);
}

}  // namespace triax::src
