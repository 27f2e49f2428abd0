// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/calibrate/calibration.hpp"

namespace triax::study {

/// A parameter file as those that ship with the program, with one set of this name (NorSand: two,
/// the second for drained loading), which says what it was calibrated on and how sure it is.
std::string calibrated_toml(const Calibration& calibration, const std::string& set_name);

/// A name that a set may have, from that of a file: "soil/my set.toml" gives "my-set".
std::string set_name_from(const std::string& file);

}  // namespace triax::study
