// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Records that hold only reduced stresses and strains enter at State: columns are taken as they are
// and completed, whichever of the pairs that missing_channels() lets through they hold:
//   σ₁′, σ₃′      q, p'      q, σ₁′      q, σ₃′      q, η      p', η
//   σ₁, σ₃, u      q, σ₃, u      q, σ_c, u
// Effective stresses, where given, come before p' and q that somebody computed from them. From q
// and η alone nothing follows where both are 0: p' is missing there.
//   ε_v = ε₁ + 2ε₃ = 3(ε₁ − ε_q) = (e₀ − e)/(1 + e₀), 0 undrained, by the first that is known
#include <optional>
#include <vector>

#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

class ReducedColumns {
 public:
  explicit ReducedColumns(const RecordHeader& header);

  /// What does not follow from the reading is NaN.
  State reduce(const Reading& reading);
  Consolidation consolidation() const;
  std::vector<Warning> warnings() const { return warnings_; }

 private:
  /// Not said to be drained: a volume that is not measured is then taken as constant.
  bool undrained(int stage) const;
  void take_stresses(const Reading& r, State& s) const;
  void take_strains(const Reading& r, State& s);
  /// The values at the start of shear are those of its first reading.
  void take_start(const Reading& r, const State& s);

  std::vector<StageInfo> stages_;
  std::optional<double> void_ratio_start_, p_eff_start_;
  std::optional<double> first_void_ratio_;    ///< that the void ratio's column holds
  std::optional<double> void_ratio_sheared_;  ///< at the start of shear, if stages came before
  bool is_sheared_ = false;
  bool only_excess_ = false;  ///< Δu is used as u
  std::vector<Warning> warnings_;
};

}  // namespace triax::lab
