// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/probe/probe_result.hpp"

namespace triax::src {

/// One JSON document; what is unknown is null. A single state is part of it; several are the list
/// "states" of objects with the same keys.
std::string probe_json(const study::ProbeResult& result);

}  // namespace triax::src
