// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Loss of control under a prescribed displacement: the specimen has no stress left.
#include <optional>

#include "lab/collapse/criterion.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Finds the first of three successive readings of a stage at which
///   p′ ≤ 0.01 p′₀,   or   |q| ≤ 0.01 max|q|  after  max|q| ≥ 0.1 p′₀,
/// p′₀ of the first state of the stage, Pa, compression positive, while the frame goes on: ε₁ is
/// within 1e-4 of the farthest so far in the direction of q. An unloading is none. The interval of
/// the instant reaches from the reading before it to the third. Under load or held q nothing is
/// searched for: there LossOfControl reports. Pre-condition: finite q, p′ and ε₁. Nova (1994):
/// under displacement control the programme is maintained through a peak of q, until p′ or q is
/// zero.
class ZeroStress {
 public:
  void start_stage(const StageInfo* stage);
  /// `now`: the latest reading by then; empty: the record had ended.
  void add_state(const State& state, bool has_time, const std::optional<Moment>& now);
  /// The first of the test.
  const std::optional<Finding>& finding() const { return finding_; }

 private:
  bool is_gone(const State& state) const;

  bool is_searched_ = true;  ///< in the stage under way
  std::optional<State> start_, before_, first_gone_;
  double max_q_ = 0;  ///< largest |q|, with its sign
  double min_strain_ = 0, max_strain_ = 0;
  int gone_count_ = 0;
  std::optional<Finding> finding_;
};

}  // namespace triax::lab
