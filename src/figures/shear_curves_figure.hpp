#pragma once
#include "src/figures/drawing.hpp"
#include "src/report/reported_test.hpp"

namespace triax::src {

/// q over the axial strain of several tests: on the left the whole of shear, on the right its
/// beginning, up to some strains at the onset of collapse. No plot without states of shear.
Drawing shear_curves_figure(const std::vector<ReportedTest>& tests);

}  // namespace triax::src
