// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/element/path_result.hpp"

namespace triax::src {

/// All rows, one column a quantity, behind remarks that say what it is; what is unknown is empty.
std::string path_csv(const study::PathResult& path);

}  // namespace triax::src
