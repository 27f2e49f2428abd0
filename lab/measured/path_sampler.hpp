// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From the states of a test to samples of its path.
#include <cmath>
#include <optional>

#include "lab/measured/block_pyramid.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Whether a state holds all that second-order work needs.
inline bool complete(const State& s) {
  return std::isfinite(s.q) && std::isfinite(s.p_eff) && std::isfinite(s.strain.axial) &&
         std::isfinite(s.volumetric_strain);
}

/// Whether second-order work is looked at in this stage: in shear, and where nobody says what a
/// stage is for. `stage` may be null.
bool is_watched(const StageInfo* stage);

/// Whether the drainage is open and the axis moved by displacement, as far as anybody says: what is
/// lost at a peak of q is then the skeleton's strength under that lateral stress.
bool is_drained_frame(const StageInfo* stage);

/// Whether strength in this stage says nothing of what was lost while the drainage was as `before`:
/// the specimen is consolidated, or water may flow that was shut in.
bool is_another_specimen(Drainage before, const StageInfo* stage);

/// Gives each complete state of the watched stages its progress: time, or the path along the axial
/// strain where the record has no time.
class PathSampler {
 public:
  explicit PathSampler(bool has_time) : has_time_(has_time) {}
  /// Empty in a gap of the pore pressure, which would be a jump to nothing; a record without any
  /// goes on without it. Pre-condition: complete(state).
  std::optional<PathSample> sample(const State& state);

 private:
  bool has_time_;
  double path_ = 0;  // along the axial strain
  double last_strain_ = kMissing;
  bool has_pore_pressure_ = false;
};

}  // namespace triax::lab
