// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/records/findings.hpp"
#include "lab/results/reading.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// Two transducers of 1 MPa, each to 0.25 % of its range, may differ by that.
inline constexpr double kMaxBackPressureExcess_pa = 5e3;

/// Notes a reading whose back pressure exceeds its cell pressure: a specimen whose drainage is open
/// cannot be confined by less than its back pressure, so that a unit or a column is wrong. Behind a
/// closed valve the controller may be at any pressure: there only the first reading of a stage
/// counts. `stage` may be null.
void check_back_pressure(const Reading& reading, const StageInfo* stage, bool begins_stage,
                         Findings& findings);

}  // namespace triax::lab
