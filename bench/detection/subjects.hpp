// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "bench/detection/trial.hpp"

namespace triax::bench {

/// Reads the list of subjects: one a line, `PROGRAMME MATERIAL VOID_RATIO collapse|stable`, #
/// before remarks. Programmes are looked for in `folder`. Throws BadInput.
std::vector<Subject> read_subjects(const std::string& list, const std::string& folder);

}  // namespace triax::bench
