// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What triax soil measured, as knowledge beforehand of parameters that mean the same.
#include <string>
#include <string_view>

#include "src/study/calibrate/calibration_start.hpp"

namespace triax::study {

/// Whether a TOML text is the result of triax soil (kind = "soil"). Throws lab::BadInput where it
/// is no TOML.
bool is_soil_result(std::string_view text, const std::string& file);

/// Values become those of the start, and with their standard errors priors of what is searched. The
/// critical state line is taken in its power form. Throws lab::BadInput.
void take_soil_result(CalibrationStart& start, std::string_view text, const std::string& file);

}  // namespace triax::study
