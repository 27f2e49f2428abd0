// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "lab/materials/material_library.hpp"

namespace triax::study {

/// The files that the parameters of a set name and that are there: the library of a UMAT, beside
/// the file of the set or in the working folder. One that only the loader finds is not among them.
std::vector<std::string> files_named_by(const lab::MaterialSet& material);

/// The same by the parameter that names them, with the SHA-256 of what they hold: what tells a
/// library from one of the same name that was built anew. Throws lab::BadInput for an unreadable
/// one.
std::vector<std::pair<std::string, std::string>> digests_of_files(const lab::MaterialSet& material);

}  // namespace triax::study
