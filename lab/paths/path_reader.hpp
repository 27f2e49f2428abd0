// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

#include "lab/paths/path_description.hpp"

namespace triax::lab {

inline constexpr double kSmallestPathTolerance = 1e-12, kLargestPathTolerance = 1e-2;
inline constexpr double kSmallestVoidRatio = 0.05, kLargestVoidRatio = 20;
inline constexpr double kSmallestPathStress_kPa = 1e-3;

/// Reads a path from TOML text; how it is written is in docs/reference/paths.md. `file` is what
/// messages call it and what files that it names are relative to. Throws BadInput (file:line, what
/// was found, what would be right). Whether the law takes the start is for check_start() to say,
/// since settings may still change it.
PathDescription read_path(std::string_view toml_text, const std::string& file);

/// The same from a file on disk.
PathDescription load_path(const std::string& path);

/// The shipped set of that name, or that of `material_file`, whose path is as seen from the folder
/// of `path_file`; empty: none.
MaterialSet find_path_material(const std::string& name, const std::string& material_file,
                               const std::string& path_file);

}  // namespace triax::lab
