// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What comes of grains in words, the same in the database, reports and files.
#include <optional>
#include <string>

#include "lab/grains/grain_run.hpp"

namespace triax::lab {

/// "in_series", "literal"
std::string word(sim::StiffnessReading reading);
/// "stress", "strain"
std::string word(sim::ProbeKind kind);
/// "isotropic", "drained", "strain_path"
std::string word(sim::GrainPathKind kind);
/// "axial_strain", "stress_ratio", "at rest", "collapse", "most_steps", "stopped"
std::string word(sim::GrainPathEnd end);
/// "at rest", "collapsed", "undecided", "stopped"
std::string word(sim::PerturbationEnd end);

/// How a stage ended: a word of the above, "at rest" or "not at rest" of a rest, and of a rose
/// "all at rest" or "some not at rest".
std::string ending(const GrainStageResult& result);

/// Whether it came to rest where it had to; empty for a path that is not isotropic.
std::optional<bool> at_rest(const GrainStageResult& result);

}  // namespace triax::lab
