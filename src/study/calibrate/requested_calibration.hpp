// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/study/calibrate/calibration.hpp"
#include "src/study/calibrate/calibration_start.hpp"

namespace triax::study {

/// Start, ranges and paths of tests of a database, by number or name (none: all); how it is
/// searched is left as it is. Throws lab::BadInput, one line: also where the law has no triaxial
/// form, and for more unknowns than the tests can tell.
CalibrationRequest requested_calibration(const StartWish& wish, const std::string& db,
                                         const std::vector<std::string>& tests);

}  // namespace triax::study
