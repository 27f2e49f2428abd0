// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/study/json_parts.hpp"
#include "src/study/probe/state_head.hpp"

namespace triax::src {

/// A probed state, with its memory and the test that it was measured in.
study::Json state_json(const study::StateHead& state);

}  // namespace triax::src
