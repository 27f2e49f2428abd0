// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The numbers of a soil as rows for text and figures.
#include <string>
#include <vector>

#include "src/study/soil/soil.hpp"

namespace triax::src {

struct SoilValue {
  std::string name;  ///< with its symbol and unit
  study::Estimate estimate;
  int decimals = 3;
};

std::vector<SoilValue> soil_values(const study::Soil& soil);

}  // namespace triax::src
