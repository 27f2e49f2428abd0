#pragma once
// What comes of grains in words, the same in the database, reports and files.
#include <optional>
#include <string_view>

#include "lab/grains/grain_run.hpp"

namespace triax::lab {

std::string_view word(sim::StiffnessReading reading);
std::string_view word(sim::GrainPathEnd end);
std::string_view word(sim::PerturbationEnd end);

/// How a stage ended: a word of the above, "settled" or "not settled" of a rest, and of a rose
/// "all settled" or "some not settled".
std::string_view ending(const GrainStageResult& result);

/// Whether it came to rest where it had to; empty for a path that is not isotropic.
std::optional<bool> settled(const GrainStageResult& result);

}  // namespace triax::lab
