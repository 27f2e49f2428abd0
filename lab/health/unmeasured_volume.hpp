// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Drained shear of a record without any measure of its volume. Where σ₃′ is constant (within 5 %
/// of its first value, at least 2 kPa) second-order work is dσ₁′ dε₁, whatever the volume does; it
/// is computed with ε_v = 0 then. Anywhere else it needs the volume.
class UnmeasuredVolume {
 public:
  explicit UnmeasuredVolume(const RecordHeader& header);

  /// `state`, or with ε_v = 0 where that changes no second-order work. In the order of readings.
  State completed(const State& state);
  /// Why second-order work cannot be computed at a state that completed() gave; empty: nothing is
  /// known to be missing but what the readings miss.
  std::string reason(const State& state) const;

 private:
  bool is_unmeasured(const State& state) const;

  RecordHeader header_;
  bool has_volume_ = true;
  std::optional<int> stage_;
  double radial_start_ = kMissing;  ///< σ₃′ at the first state of the stage
};

}  // namespace triax::lab
