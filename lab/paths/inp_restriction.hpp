// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>
#include <vector>

#include "lab/paths/inp_lines.hpp"
#include "sim/point/path.hpp"

namespace triax::lab {

/// A line of *ObeyRestrictions, "-sd1 + 3.0*ed2 = -10 ! comment", as row `row` of the conditions.
/// sd1 to sd6 are increments of stress (kPa), ed1 to ed6 of strain, over the whole step. Throws
/// BadInput through `lines`.
void read_inp_restriction(std::string_view line, int row, const InpLines& lines,
                          sim::MixedControl<sim::Tensor>& conditions);

/// What stands behind the question mark, "s1 < -200": the end of a step. A condition on a sum or on
/// a state variable is refused; where q is meant with its sign a warning is added. Throws BadInput
/// through `lines`.
sim::PathEnd read_inp_end(std::string_view condition, const InpLines& lines,
                          std::vector<std::string>& warnings);

}  // namespace triax::lab
