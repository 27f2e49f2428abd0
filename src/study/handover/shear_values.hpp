// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a result sheet says of shear: its start, its failure, its cycles.
#include <cstdint>
#include <optional>
#include <vector>

#include "db/store.hpp"
#include "lab/measured/undrained_strength.hpp"

namespace triax::study {

/// One scan as a sheet needs it: SI, NaN where it is not known.
struct ScanValues {
  lab::State state;
  double cell_pressure = lab::kMissing;  ///< total σ₃
  double back_pressure = lab::kMissing;
};

/// One cycle of load by the count of the logger.
struct CycleValues {
  std::int64_t cycle = 0;
  double q_low = 0, q_high = 0;
  double strain_low = 0, strain_high = 0;
  double q_at_strain_low = 0, q_at_strain_high = 0;
  double u_low = lab::kMissing, u_high = lab::kMissing;
  ScanValues last;  ///< its last scan
};

/// Axial strain up to which the largest q of a test of total stresses is looked for (ISO 17892-8).
inline constexpr double kLastTotalStrain = lab::kIsoFailureStrain;

struct ShearValues {
  std::optional<ScanValues> start;  ///< first scan of shear with known stresses
  /// Of the largest |q| in shear; of a test of total stresses up to kLastTotalStrain.
  std::optional<ScanValues> failure;
  /// Axial strain at which |q| first reaches half of that at failure, between two scans; where
  /// shear begins above that, nothing.
  std::optional<double> half_strain;
  double largest_p_eff = lab::kMissing;
  std::vector<CycleValues> cycles;  ///< empty: nobody counted
};

/// Reads the scans of the test once, in constant memory beside the cycles (at most kMostCycles).
ShearValues shear_values(const db::Store& store, const db::StoredTest& test);
inline constexpr std::size_t kMostCycles = 20'000;

}  // namespace triax::study
