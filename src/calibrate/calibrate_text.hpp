// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/calibrate/calibration.hpp"

namespace triax::src {

/// The result for a terminal.
std::string calibrate_text(const study::Calibration& calibration);

}  // namespace triax::src
