// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/base/toml_reader.hpp"
#include "lab/grains/grain_programme.hpp"

namespace triax::lab {

/// One table of [[stages]] with all but what its `from` means. Throws BadInput.
GrainStage read_grain_stage(const TomlTable& table);

/// The words for `action`.
std::vector<std::string> grain_actions();

}  // namespace triax::lab
