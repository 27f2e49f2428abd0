// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "db/grain_store.hpp"

namespace triax::src {

/// The specimen, a table of the stages, and tables of what paths, rests, probes and perturbations
/// came to, for people; with short names of stages no line is longer than 100 columns.
std::string grain_text(const db::StoredGrainRun& run);

/// A table of the runs, and each in full.
std::string grain_runs_text(const std::vector<db::StoredGrainRun>& runs);

}  // namespace triax::src
