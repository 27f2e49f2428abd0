// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/study/soil/soil.hpp"

namespace triax::src {

/// FOLDER/soil.toml, or soil_GROUP.toml of several, and the figures beside it. Pre-condition: the
/// folder is there.
void write_soil_files(const std::vector<study::Soil>& soils, const std::string& folder);

}  // namespace triax::src
