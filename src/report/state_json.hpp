#pragma once
#include "src/report/json_parts.hpp"
#include "src/report/probed_state.hpp"

namespace triax::src {

/// A probed state, with its memory and the test that it was measured in.
Json state_json(const StateHead& state);

}  // namespace triax::src
