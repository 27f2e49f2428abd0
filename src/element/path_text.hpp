// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/element/path_result.hpp"

namespace triax::src {

/// A short table, the events and the verdict, for people.
std::string path_text(const study::PathResult& path);

}  // namespace triax::src
