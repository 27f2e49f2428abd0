// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The commands of lammps_export.hpp.
#include <string>

#include "lab/grains/lammps_export.hpp"
#include "lab/grains/size_bins.hpp"

namespace triax::lab {

/// Pre-condition: all that lammps_export() checks; a title on one line.
std::string lammps_script(const sim::GrainState& state, const sim::GrainPath& path,
                          const SizeBins& bins, const LammpsOptions& options);

}  // namespace triax::lab
