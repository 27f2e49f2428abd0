#pragma once
#include <string>

#include "sim/grains/grain_state.hpp"

namespace triax::lab {

/// Whole or not at all.
void save_state(const std::string& path, const sim::GrainState& state);
/// Throws BadInput with the file's name.
sim::GrainState load_state(const std::string& path);

}  // namespace triax::lab
