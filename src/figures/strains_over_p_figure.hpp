#pragma once
#include "src/figures/drawing.hpp"
#include "src/report/reported_test.hpp"

namespace triax::src {

/// Axial strain (left) and volumetric strain (right) over p′ of several tests, up to some strains
/// at the onset of collapse: what a specimen does while p′ is lowered at constant q. No plot
/// without states of shear.
Drawing strains_over_p_figure(const std::vector<ReportedTest>& tests);

}  // namespace triax::src
