// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/programmes/programme.hpp"

namespace triax::lab {

class TomlTable;

/// Reads [rig]: instruments, controllers, frame, water. The specimen's effective stress at the
/// start must have been read: with the back pressure it is the cell pressure. Throws BadInput.
void read_rig(const TomlTable& table, Programme& programme);

}  // namespace triax::lab
