// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/probe/strain_paths.hpp"

namespace triax::src {

/// One JSON document; what is unknown is null.
std::string strain_paths_json(const study::StrainPathsResult& result);

}  // namespace triax::src
