// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/cli/command.hpp"

namespace triax::src {

/// `triax about`: version, licence and source; with --rules the table of rules of an assessment and
/// all limits.
Command about_command();

/// The rules of an assessment, and the limits of assessments, sensors and warnings, each with its
/// value, unit, reason and origin.
std::string rules_text();

}  // namespace triax::src
