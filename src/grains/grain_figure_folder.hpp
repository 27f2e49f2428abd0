// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "db/grain_store.hpp"

namespace triax::src {

/// Writes the figures of each run, with the numbers behind them, into a folder that exists, as
/// NAME_FIGURE.svg, .png, .pdf, .csv and .json: NAME is that of the programme as
/// lab::in_file_name() has it; of two runs with one name the second has its id behind it
/// (FileNames). Gives the prefixes written. Throws lab::BadInput, lab::WorkFailed.
std::vector<std::string> write_grain_figures(const std::vector<db::StoredGrainRun>& runs,
                                             const std::string& folder);

}  // namespace triax::src
