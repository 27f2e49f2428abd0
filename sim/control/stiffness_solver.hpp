// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/control/control_solver.hpp"

namespace triax::sim {

/// solve_control for the stiffness form; equations in control_solver.hpp.
template <class Space>
PointRate<Space> solve_stiffness(const StiffnessForm<Space>& form,
                                 const PreparedControl<Space>& control, const Branch& branch);

}  // namespace triax::sim
