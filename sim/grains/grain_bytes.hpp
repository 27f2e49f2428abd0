#pragma once
// A GrainState as bytes, whole: what is restored continues bit for bit. Little-endian, with a magic
// word, a version and a checksum; for one kind of machine, not an exchange format.
#include <cstddef>
#include <span>
#include <vector>

#include "sim/grains/grain_state.hpp"

namespace triax::sim {

std::vector<std::byte> save_grains(const GrainState& state);

/// Throws std::invalid_argument, one line, if the bytes are no state, of another version, cut short
/// or damaged.
GrainState load_grains(std::span<const std::byte> bytes);

}  // namespace triax::sim
