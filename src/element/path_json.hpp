// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/element/path_result.hpp"

namespace triax::src {

/// One JSON document; what is unknown is null.
std::string path_json(const study::PathResult& path);

}  // namespace triax::src
