// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One material point taken along a path, without apparatus.
#include <string>
#include <utility>
#include <vector>

#include "src/study/element/path_result.hpp"
#include "src/study/progress.hpp"

namespace triax::study {

/// The path of a path file, or of the files of incrementalDriver, with these settings of
/// lab::change_setting in place of the file's: a material first, in whatever order they stand, and
/// `material`, which no file has, before them all. Throws lab::BadInput.
lab::PathDescription described_path(const std::string& file,
                                    std::vector<std::pair<std::string, std::string>> settings,
                                    const std::optional<lab::MaterialSet>& material = {});

/// The name of the path is what is under way. Pre-condition: lab::check_start(description) passes.
PathResult run_element(const lab::PathDescription& description, const Progress& progress = {});

}  // namespace triax::study
