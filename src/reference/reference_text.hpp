// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "lab/ags/triaxial_results.hpp"

namespace triax::src {

/// What the file is and where its results went, then the results as tables of at most `width`
/// columns where their numbers leave room, then what was assumed. A column of which nothing is
/// known is left out.
std::string reference_text(const lab::AgsResults& file, const std::string& db, std::size_t width);

}  // namespace triax::src
