// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/control/control_solver.hpp"

namespace triax::sim {

/// solve_control for the interpolated form; equations in control_solver.hpp.
template <class Space>
PointRate<Space> solve_interpolated(const InterpolatedForm<Space>& form,
                                    const PreparedControl<Space>& control,
                                    const Vector<Space>& guess);

}  // namespace triax::sim
