// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/results/reading.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab::testing {

inline RecordHeader raw_header() {
  RecordHeader header;
  header.source = "test.csv";
  header.columns = {Quantity::axial_displacement, Quantity::axial_force,   Quantity::cell_pressure,
                    Quantity::back_pressure,      Quantity::pore_pressure, Quantity::back_volume};
  header.specimen.height_m = 0.140;
  header.specimen.diameter_m = 0.070;
  header.specimen.void_ratio = 1.1;
  header.stages = {
      {.number = 1, .name = "b", .role = StageRole::b_check, .drainage = Drainage::closed},
      {.number = 2, .name = "c", .role = StageRole::consolidation, .drainage = Drainage::open},
      {.number = 3, .name = "s", .role = StageRole::shear, .drainage = Drainage::open}};
  return header;
}

struct Scan {
  int stage;
  double displacement_mm, force_kN, cell_kPa, pore_kPa, volume_mm3;
};

inline Reading reading(const Scan& scan, std::int64_t number = 0) {
  Reading r;
  r.number = number;
  r.time_s = static_cast<double>(number);
  r.stage = scan.stage;
  r.line = number + 2;
  r[Quantity::axial_displacement] = scan.displacement_mm * 1e-3;
  r[Quantity::axial_force] = scan.force_kN * 1e3;
  r[Quantity::cell_pressure] = scan.cell_kPa * 1e3;
  r[Quantity::back_pressure] = scan.pore_kPa * 1e3;
  r[Quantity::pore_pressure] = scan.pore_kPa * 1e3;
  r[Quantity::back_volume] = scan.volume_mm3 * 1e-9;
  return r;
}

}  // namespace triax::lab::testing
