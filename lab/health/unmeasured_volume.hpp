// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Drained shear of a record without any measure of its volume. If σ₃′ is constant (within 5 % of
/// its first value, at least 2 kPa), second-order work is dσ₁′ dε₁ for any volume change and is
/// computed with ε_v = 0. Otherwise it needs the volume change.
class UnmeasuredVolume {
 public:
  explicit UnmeasuredVolume(const RecordHeader& header);

  /// Returns `state`, with ε_v = 0 if that does not change second-order work. Pre-condition: the
  /// states come in the order of readings.
  State completed(const State& state);
  /// The reason why second-order work cannot be computed at a state that completed() returned;
  /// empty if its volume change is known or not needed.
  std::string reason(const State& state) const;

 private:
  bool is_unmeasured(const State& state) const;

  RecordHeader header_;
  bool has_volume_ = true;
  std::optional<int> stage_;
  double radial_start_ = kMissing;  ///< σ₃′ at the first state of the stage
};

}  // namespace triax::lab
