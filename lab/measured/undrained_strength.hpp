// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "lab/measured/largest_strength.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// Largest axial strain at which ISO 17892-8 looks for failure in total stresses, and the one at
/// which ASTM D2850 ends.
inline constexpr double kIsoFailureStrain = 0.20, kAstmFailureStrain = 0.15;

/// Failure of a test in total stresses, c_u = |q|/2, in constant memory. Needs q and the axial
/// strain only.
class UndrainedStrengthFinder {
 public:
  /// The next state of shear; one without q or axial strain is passed over.
  void add(const State& state);
  /// Largest |q| of all states.
  const std::optional<State>& peak() const { return peak_.state(); }
  /// Empty before a state was added.
  std::optional<UndrainedStrength> result(bool has_time) const;

 private:
  LargestStrength peak_, up_to_iso_strain_;
  std::optional<State> at_astm_strain_;
  double last_strain_ = 0, last_q_ = 0;
};

}  // namespace triax::lab
