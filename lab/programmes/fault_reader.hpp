// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/programmes/programme.hpp"

namespace triax::lab {

class TomlTable;

/// Reads one [[faults]] table. The programme's rig and scan interval must have been read: a fault
/// that the rig cannot have is refused. Throws BadInput that lists what is possible.
Fault read_fault(const TomlTable& table, const Programme& programme);

}  // namespace triax::lab
