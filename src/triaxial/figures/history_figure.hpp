#pragma once
#include "src/plot/drawing.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

enum class Span {
  shear,  ///< the shear stages; the whole record where no stage is known to be shear
  onset,  ///< the neighbourhood of the onset of collapse
};

/// q, pore pressure (volumetric strain where none was measured), axial strain and normalised
/// second-order work one above the other on one common time axis, with the onset of collapse marked
/// through all of them. A record without time is drawn along its axial strain. No plot where there
/// is nothing to draw.
Drawing history_figure(const study::TestResult& test, Span span);

}  // namespace triax::src
