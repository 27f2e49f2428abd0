// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reads a programme of grains from TOML; the keys are in docs/how-to/grains.md.
#include <string>
#include <string_view>
#include <vector>

#include "lab/base/toml_reader.hpp"
#include "lab/grains/grain_programme.hpp"

namespace triax::lab {

/// Most grains of a specimen.
inline constexpr int kMostGrains = 2000000;

/// Throws BadInput, one line with file, line and key: a key that is unknown or missing, a value out
/// of its bounds, a stage that starts from one that is not before it. Files that it names are not
/// opened.
GrainProgramme read_grain_programme(std::string_view toml_text, const std::string& file,
                                    const std::vector<TomlEdit>& edits = {});
GrainProgramme load_grain_programme(const std::string& path,
                                    const std::vector<TomlEdit>& edits = {});

}  // namespace triax::lab
