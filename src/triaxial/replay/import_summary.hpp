// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "lab/reduction/reduction.hpp"
#include "lab/rig/recorded.hpp"

namespace triax::src {

/// A summary of the record read with these options: rows, time, strains, p' at the start, peak of q
/// and drainage. Reads the whole record. Throws BadInput if it cannot be read or reduced.
std::string import_summary(lab::RecordedRig& record, const lab::ReductionOptions& options);

}  // namespace triax::src
