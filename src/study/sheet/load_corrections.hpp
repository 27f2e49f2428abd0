// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What side drains and the piston carry of the deviator stress at failure. A sheet shows it and
// says so; stored stresses, circles and figures are without it.
//
// Vertical strips of filter paper (ASTM D4767, ISO 17892-9), in compression only:
//   Δq = K_fp P_fp/A_c · min(ε₁/0.02, 1)        P_fp = share · π D_c, of half the circumference or
//                                               less;  A_c = π D_c²/4, at the start of shear
// where K_fp is not said by the diameter, Table 2 of BS 1377-8 (half the circumference):
//   38 mm 10 kPa, 50 mm 7 kPa, 70 mm 5 kPa, 100 mm 3.5 kPa, 150 mm 2.5 kPa, a line between
// which is K_fp = 0.19 kN/m within a tenth. Spirals: none.
//
// A load cell above the cell (ASTM D4767, D7181), F less what the piston itself makes of it:
//   Δq = (R + a_p (σ_c − σ_c0) − m g)/A
// R friction of the piston; a_p its area; σ_c0 the cell pressure at which the load was set to
// zero (that at the start of shear); m what is below the load cell and not in
// its zero; A the area at failure.
#include <optional>
#include <string>

#include "src/study/sheet/sheet_values.hpp"
#include "src/study/sheet/sheet_words.hpp"

namespace triax::study {

/// Pa. Pre-conditions: diameter_m > 0, 0 <= cover <= 0.5.
double side_drain_stress(double load_n_per_m, double cover, double diameter_m, double axial_strain);
/// Pa, by Table 2 of BS 1377-8. Outside of 38 to 150 mm the nearest row.
double side_drain_stress(double diameter_m, double axial_strain);

struct SideDrains {
  double taken_off_pa = 0;
  /// K_fp of the formula; nothing: by the table.
  std::optional<double> load_n_per_m;
  double cover = 0.5, diameter_m = 0;
};

struct Piston {
  double taken_off_pa = 0;
  double friction_n = 0, area_m2 = 0, weight_n = 0;
  double cell_pressure_pa = 0, zero_pressure_pa = 0;
  double specimen_area_m2 = 0;
};

struct LoadCorrections {
  std::optional<SideDrains> side_drains;  ///< nothing: none are said, or they carry nothing
  std::optional<Piston> piston;           ///< nothing: nothing is said of it
  std::string why_no_side_drains, why_no_piston;
  /// Σ Δq, Pa; of q at failure.
  double taken_off_pa() const;
  /// q at failure less that, in the sense of q; nothing where none of the two is known.
  std::optional<double> q_left_pa(const SheetValues& values) const;
};

/// At failure; of a record that was reduced before, nothing.
LoadCorrections load_corrections(const db::StoredTest& test, const SheetValues& values,
                                 const SheetWords& words);

}  // namespace triax::study
