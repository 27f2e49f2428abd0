// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A GrainState as bytes, whole: what is restored continues bit for bit. Little-endian, with a magic
// word, a version and a checksum; for one kind of machine, not an exchange format.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

std::vector<std::byte> save_grains(const GrainState& state);

/// Throws std::invalid_argument, one line, if the bytes are no state, of another version, cut short
/// or damaged, or if the engine could not go on from what they hold (grain_check.hpp).
GrainState load_grains(std::span<const std::byte> bytes);

/// The checksum that save_grains() writes: states that differ in a bit have different ones, but for
/// chance.
std::uint64_t fingerprint(const GrainState& state);

/// Writes the right checksum into bytes that were changed, for those who test what lies behind it.
/// Bytes too short to have one are left alone.
void seal_grains(std::span<std::byte> bytes);

}  // namespace triax::sim
