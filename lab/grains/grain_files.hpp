// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A state of a specimen of grains as a file (sim/grains/state/grain_bytes.hpp): what is loaded goes
// on bit for bit.
#include <cstdint>
#include <string>

#include "sim/grains/state/grain_state.hpp"

namespace triax::lab {

/// No larger file is read or written: some million grains.
inline constexpr std::uintmax_t kLargestStateFile = std::uintmax_t{4} << 30;

/// The file appears whole or not at all. Throws BadInput where `path` is a folder or a device,
/// WorkFailed where it cannot be written or the state is too large.
void save_state(const std::string& path, const sim::GrainState& state);

/// Throws BadInput, one line that names the file: it is not there or no file, too large, no state,
/// of another version, damaged, or one that the engine could not go on from.
sim::GrainState load_state(const std::string& path);

}  // namespace triax::lab
