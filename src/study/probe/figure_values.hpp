// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the figures of probes show: which states, and their circles fine enough to be drawn.
#include <vector>

#include "src/study/probe/probe_result.hpp"

namespace triax::study {

/// Of the states with an answer all, or some evenly spread with the first and the last among them,
/// as many as one diagram can hold and still be read. Where the result's directions are more than
/// 2° apart the circles are probed again, every 1°. Cones are left out where they would lie on each
/// other. Pre-condition: `probed` are the states of the result, in their order and in the space of
/// its plane.
template <class Space>
ProbeFigureValues figure_values(const ProbeResult& result,
                                const std::vector<StateToProbe<Space>>& probed);

extern template ProbeFigureValues figure_values(
    const ProbeResult&, const std::vector<StateToProbe<sim::Axisymmetric>>&);
extern template ProbeFigureValues figure_values(const ProbeResult&,
                                                const std::vector<StateToProbe<sim::Tensor>>&);

}  // namespace triax::study
