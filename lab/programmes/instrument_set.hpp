// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

#include "lab/base/toml_reader.hpp"

namespace triax::lab {

/// A ready set of instruments by its name ("ideal", "standard", "advanced"): the tables of a
/// programme's [rig] that it fills in. Throws BadInput that lists the known ones and the nearest.
TomlTable find_instruments(std::string_view name);

}  // namespace triax::lab
