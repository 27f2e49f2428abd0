// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/programmes/programme.hpp"

namespace triax::lab {

class TomlTable;

/// Reads scan_interval_s and averaging_s of [test] or of a stage, where they stand beside those of
/// the test. Throws BadInput.
Logging read_logging(const TomlTable& table, const Logging& otherwise);

/// Reads one [[stages]] table. `cell_pa` and `back_pa` are the controllers' pressures at its start,
/// as far as the programme tells, and are moved on to its end: from them follows whether an end
/// that waits for a pressure can come at all. Throws BadInput.
Stage read_stage(const TomlTable& table, const Programme& programme, double& cell_pa,
                 double& back_pa);

}  // namespace triax::lab
