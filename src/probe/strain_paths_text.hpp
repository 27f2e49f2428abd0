// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/probe/strain_paths.hpp"

namespace triax::src {

/// Where each path has its peak and where second-order work vanishes, for people.
std::string strain_paths_text(const study::StrainPathsResult& result);

}  // namespace triax::src
