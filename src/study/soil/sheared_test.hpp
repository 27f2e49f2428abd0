// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One test as the study of a soil needs it.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/store.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace triax::study {

struct ShearedTest {
  std::int64_t id = 0;
  std::string name, material, programme;
  std::string digest;  ///< of the file; empty: a simulation
  bool simulated = false, complete = true;
  lab::Drainage drainage = lab::Drainage::unknown;  ///< of shear
  std::optional<double> void_ratio;                 ///< at the start of shear
  std::optional<double> p_eff_pa;                   ///< p′₀
  std::vector<lab::State> states;                   ///< of shear, in order
  std::optional<lab::CollapseKind> collapse;        ///< empty: not judged
  std::optional<lab::Instant> onset;                ///< of collapse
  std::optional<lab::CyclicLoading> cyclic;
};

/// Reads a test back; of a long one some twenty thousand states at even steps.
ShearedTest load_sheared_test(const db::Store& store, std::int64_t id);

}  // namespace triax::study
