// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/calibrate/calibration.hpp"

namespace triax::study {

/// The whole result as one document; units of the field, an unknown value is null.
std::string calibration_json(const Calibration& calibration);

}  // namespace triax::study
