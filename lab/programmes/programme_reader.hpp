// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "lab/base/toml_reader.hpp"
#include "lab/programmes/programme.hpp"

namespace triax::lab {

/// A key of a programme that names another file, as seen from the folder of the programme.
struct ProgrammeFileKey {
  std::string_view table;
  std::string_view key;
};
/// All of them. The reader opens no file that another key names.
inline constexpr std::array<ProgrammeFileKey, 2> kProgrammeFileKeys{
    {{"specimen", "material_file"}, {"specimen", "grains"}}};

/// The first key of the document that names another file, as "specimen.grains"; empty without one.
/// For programmes from a source that may not read files. Opens no file.
std::optional<std::string> find_file_key(const TomlTable& document);

/// Reads a programme from TOML text. `file` is what messages call it; files that the programme
/// names are looked for beside it. Throws BadInput (file:line, what was found, what would be right)
/// on unknown keys, wrong types, values that no specimen or rig can have and ends that can never
/// come. `edits` are put into the document before it is read.
Programme read_programme(std::string_view toml_text, const std::string& file,
                         const std::vector<TomlEdit>& edits = {});

/// The same from a file on disk; throws BadInput if it cannot be read.
/// `changes` are edits that the programme remembers, so that the test it makes says so.
Programme load_programme(const std::string& path, const std::vector<TomlEdit>& changes = {});

/// Puts what was changed into the programme's name, as the tests of a sweep are named: "CSU 26
/// [void_ratio 1.12]".
void name_after_changes(Programme& programme);

}  // namespace triax::lab
