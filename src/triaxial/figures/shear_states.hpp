#pragma once
// The part of a test that figures of its shear show.
#include <QPointF>
#include <optional>
#include <vector>

#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

/// True for a stage of shear, and where the record does not say what the stage was.
bool is_shear(const lab::RecordHeader& header, int stage);

/// What an axis shows of a state, in the unit of the axis; NaN where it is not known.
using StateValue = double (*)(const lab::State&);

/// States of shear as points of a plane, in order; those not known in both are left out.
std::vector<QPointF> shear_points(const study::TestResult& test, StateValue x, StateValue y);

/// The same up to the first point outside these bounds: what an axis would cut off on a screen, an
/// SVG shows.
std::vector<QPointF> shear_points_within(const study::TestResult& test, StateValue x, StateValue y,
                                         double x_most, double y_most);

/// The state nearest to the onset of collapse among those kept for drawing; nothing without a
/// collapse or without states.
std::optional<lab::State> state_at_onset(const study::TestResult& test);

}  // namespace triax::src
