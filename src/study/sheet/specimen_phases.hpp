// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The specimen as built, at the start of shear and at its end: dimensions, masses, densities.
#include <optional>

#include "src/study/sheet/sheet_values.hpp"
#include "src/study/sheet/sheet_words.hpp"

namespace triax::study {

/// SI, with V = π D² H/4 where no volume change is known otherwise:
///   ρ = m/V     ρ_d = m_d/V = G_s ρ_w/(1 + e)     w = (m − m_d)/m_d     S_r = w G_s/e
struct SpecimenPhase {
  std::optional<double> height_m, diameter_m, mass_kg, water_content, bulk_density, dry_density,
      void_ratio, saturation;
  bool saturation_is_assumed = false;  ///< S_r = 1, and w with it
};

struct SpecimenPhases {
  SpecimenPhase built, start, end;
};

SpecimenPhases specimen_phases(const db::StoredTest& test, const SheetValues& values,
                               const SheetWords& words);

}  // namespace triax::study
