// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>
#include <vector>

#include "lab/base/toml_reader.hpp"

namespace triax::lab {

/// The file lab/intake/lexicon/NAME.toml that is embedded in the program. Pre-condition: it exists.
TomlTable read_lexicon_file(std::string_view name);
/// The files that describe a quantity, by name, each read once.
const std::vector<TomlTable>& lexicon_quantity_files();

}  // namespace triax::lab
