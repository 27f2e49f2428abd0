// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What triax soil measured, as knowledge beforehand of parameters that mean the same.
#include "lab/base/toml_reader.hpp"
#include "src/study/calibrate/calibration_start.hpp"

namespace triax::study {

/// Whether a document is the result of triax soil (kind = "soil").
bool is_soil_result(const lab::TomlTable& root);

/// Values become those of the start, and with their standard errors priors of what is searched. The
/// critical state line is taken in its power form. Throws lab::BadInput.
void take_soil_result(CalibrationStart& start, const lab::TomlTable& root);

}  // namespace triax::study
