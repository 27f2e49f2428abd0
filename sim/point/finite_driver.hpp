// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/point/point_driver.hpp"

namespace triax::sim {

/// advance_point for a law that integrates finite increments itself. The control is met by Newton's
/// method with the law's own tangent, or with one found by differences where that does not lead
/// there. The error is that between one increment and two halves of it, of stress and of strain;
/// the increment is cut until it is within the tolerance, but never below a thousandth of what was
/// asked for (a foreign law's own accuracy is the limit: less than 1e-6 is not asked of it).
///
/// Control is lost where no part of an increment down to `smallest_step` can be met and
/// det(S T + E) has vanished against that of the elastic response; failed is everything else.
template <class Space>
PointStep<Space> advance_finite(const Law<Space>& law, const PointState<Space>& state,
                                const MixedControl<Space>& wanted, const PointTolerance& tolerance);

/// point_rate of such a law: the quotient of a small increment (strain 1e-7) that meets the
/// control. Not controllable with limiting_variable −1 also where the law itself fails.
template <class Space>
PointRate<Space> finite_rate(const Law<Space>& law, const PointState<Space>& state,
                             const MixedControl<Space>& control);

}  // namespace triax::sim
