// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A test that does not go straight to its onset: it rests on the way, or goes back a little first.
#include <cstdint>

#include "lab/programmes/programme.hpp"

namespace triax::bench {

enum class Interruption { none, pause, loop };

/// What the seed chooses: 15 % of the seeds rest for a quarter of the time that shear took so far,
/// another 15 % go back at the rate at which they came for an eighth of it.
Interruption interruption(std::uint64_t seed);

/// The same programme with its last stage of shear interrupted at 0.4 of the way from its start to
/// the onset, or at 0.05 of it where there is none; as it is where a stage of dead load has no way.
/// Runs the test once for that.
lab::Programme interrupted(lab::Programme programme, Interruption how, std::uint64_t seed);

}  // namespace triax::bench
