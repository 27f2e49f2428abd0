#pragma once
#include <string>
#include <vector>

#include "src/figures/drawing.hpp"

namespace triax::src {

/// The effective stress of a test where collapse set in, and the direction it was moving in. SI.
struct CollapseIncrement {
  std::string test;       ///< its name
  std::string programme;  ///< "ICU", "CSD"...; empty: unknown
  double p_pa = 0, q_pa = 0;
  double dp = 0, dq = 0;  ///< in any one unit; only their ratio and their signs are drawn
};

/// An arrow of one length from each collapse point along its stress increment, in the q-p′ plane
/// with one unit of stress as long on both axes; beside each point the name of its test. No plot
/// without increments. `origin`: the note below (origin_note.hpp).
Drawing stress_increments_figure(const std::vector<CollapseIncrement>& increments,
                                 const std::string& origin);

}  // namespace triax::src
