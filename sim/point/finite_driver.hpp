#pragma once
#include "sim/point/point_driver.hpp"

namespace triax::sim {

/// advance_point for a law that integrates finite increments itself. The control is met by Newton's
/// method with the law's own tangent; the error is that between one increment and two halves of it,
/// and the increment is cut until that is within the tolerance (a foreign law's own accuracy is the
/// limit: below 1e-6 it is not asked for).
template <class Space>
PointStep<Space> advance_finite(const Law<Space>& law, const PointState<Space>& state,
                                const MixedControl<Space>& control,
                                const PointTolerance& tolerance);

}  // namespace triax::sim
