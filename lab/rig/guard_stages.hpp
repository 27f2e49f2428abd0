// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The stages in which a test goes on once its guard has acted. The header of a record is complete
// before its first reading, so each guarded stage has its own from the start.
#include <optional>
#include <string>
#include <vector>

#include "lab/programmes/programme.hpp"
#include "lab/rig/seen.hpp"

namespace triax::lab {

struct GuardedProgramme {
  Programme programme;  ///< the stages of the guard after those of the file
  /// For each stage the place of the one that takes over; empty: none does.
  std::vector<std::optional<std::size_t>> successor;
};

/// With hand_over a stage of shear by displacement follows each guarded one, with unload a stage of
/// which nothing is judged; the valve is as it was, both pressures are held.
GuardedProgramme with_guard_stages(Programme programme);

/// Sets direction and end of the successor by what is seen when the guard acts: on towards where
/// the specimen is loaded until the further strain is reached, or back until the share of q is off.
void aim(const Guard& guard, const Seen& seen, double height_m, Stage& successor);

/// "switched to displacement at 0.05 mm/min", what the guard did, in words.
std::string describe(const Guard& guard);

}  // namespace triax::lab
