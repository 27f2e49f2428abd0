// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

namespace triax::study {

/// The effective stress of a test where collapse set in, and the direction it was moving in. SI.
struct CollapseIncrement {
  std::string test;       ///< its name
  std::string programme;  ///< "ICU", "CSD"...; empty: unknown
  double p_pa = 0, q_pa = 0;
  double dp = 0, dq = 0;  ///< in any one unit; only their ratio and their signs are drawn

  /// Of (dp′, dq), turned counter-clockwise from isotropic unloading (dq = 0, dp′ < 0), within
  /// ±180°.
  double degrees_from_unloading() const;
};

struct DirectionRange {
  double lowest_deg = 0, highest_deg = 0;  ///< from isotropic unloading
};

/// Pre-condition: at least one increment.
DirectionRange direction_range(const std::vector<CollapseIncrement>& increments);

}  // namespace triax::study
