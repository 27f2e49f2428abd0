// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/programmes/programme.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// What a record of this programme says of itself before its first reading. Behind the programme's
/// stages stands one more, for a rig that is held or in its safe state.
RecordHeader rig_header(const Programme& programme, std::uint64_t seed);

}  // namespace triax::lab
