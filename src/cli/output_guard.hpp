// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

namespace triax::src {

/// The files of a database: itself and those that SQLite keeps beside it.
std::vector<std::string> database_files(const std::string& db);

/// Throws lab::BadInput where `output` is one of the `kept` files, under whichever name (links,
/// dots in the path), or would become one that does not exist yet. `option` is how the user gave
/// it; `what` names the kept files in the message. "-" and an empty output are never one of them.
void refuse_overwriting(const std::string& option, const std::string& output,
                        const std::vector<std::string>& kept, const std::string& what);

/// What the names of a command's files in the folder of --output begin with: "FOLDER/probe"; empty
/// for an empty folder.
std::string prefix_in(const std::string& folder, const std::string& command);

/// Makes the folder that the user gave with `option`; files are written only after. Throws
/// lab::BadInput where there is none afterwards.
void make_folder(const std::string& option, const std::string& folder);

/// PREFIX with each of these names and each ending of data and figures: "x_cones.svg".
std::vector<std::string> files_of_prefix(const std::string& prefix,
                                         const std::vector<std::string>& names = {""});

/// Finds out before anything is computed whether the folder could be made, if there is none yet,
/// and these files in it be written at the end. Throws lab::BadInput where a file stands in its
/// place or a target is a folder, lab::WorkFailed where nothing can be written there.
void check_folder(const std::string& option, const std::string& folder,
                  const std::vector<std::string>& targets);

/// The same of single files. Throws lab::BadInput if `output`, as the user gave it, is a folder or
/// its folder does not exist, lab::WorkFailed if that is not writable. "-" is always possible.
void check_targets(const std::string& option, const std::string& output,
                   const std::vector<std::string>& targets);

}  // namespace triax::src
