// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/plot/drawing.hpp"
#include "src/study/triaxial/collapse_increment.hpp"

namespace triax::src {

/// An arrow of one length from each collapse point along its stress increment, in the q-p′ plane
/// with one unit of stress as long on both axes; beside each point the name of its test. No plot
/// without increments. `origin`: the note below (origin_note.hpp).
Drawing stress_increments_figure(const std::vector<study::CollapseIncrement>& increments,
                                 const std::string& origin);

}  // namespace triax::src
