// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The synthetic record as reduction gives it.
#include "bench/replay/synthetic_record.hpp"
#include "lab/results/state.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::bench {

inline lab::State reduced(const RawRow& r, long i) {
  lab::State s;
  s.reading = i;
  s.time_s = r.time_s;
  const double strain = r.displacement_mm / SyntheticRecord::kHeight_mm;
  const double area = std::numbers::pi * 0.035 * 0.035 / (1 - strain);
  s.strain = {strain, -strain / 2};
  s.volumetric_strain = 0;
  s.q = r.force_kN * 1e3 / area;
  s.pore_pressure = r.pore_kPa * 1e3;
  s.effective_stress = {r.cell_kPa * 1e3 + s.q - s.pore_pressure,
                        r.cell_kPa * 1e3 - s.pore_pressure};
  s.p_eff = sim::mean_stress(s.effective_stress);
  return s;
}

}  // namespace triax::bench
