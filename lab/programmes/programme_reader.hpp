// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

#include "lab/base/toml_reader.hpp"
#include "lab/programmes/programme.hpp"

namespace triax::lab {

/// Reads a programme from TOML text. `file` is what messages call it and where a material_file is
/// looked for beside. Throws BadInput (file:line, what was found, what would be right) on unknown
/// keys, wrong types, values that no specimen or rig can have and ends that can never come. `edits`
/// are put into the document before it is read.
Programme read_programme(std::string_view toml_text, const std::string& file,
                         const std::vector<TomlEdit>& edits = {});

/// The same from a file on disk; throws BadInput if it cannot be read.
/// `changes` are edits that the programme remembers, so that the test it makes says so.
Programme load_programme(const std::string& path, const std::vector<TomlEdit>& changes = {});

/// Puts what was changed into the programme's name, as the tests of a sweep are named: "CSU 26
/// [void_ratio 1.12]".
void name_after_changes(Programme& programme);

}  // namespace triax::lab
