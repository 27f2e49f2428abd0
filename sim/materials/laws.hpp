// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/law/parameters.hpp"

namespace triax::sim {

/// Every law that the program knows, in the order of `triax materials`. A new law is a file pair, a
/// parameter file, a line here and a test.
const std::vector<LawDescription>& laws();

/// The law of that name, or nullptr.
const LawDescription* find_law(std::string_view name);

}  // namespace triax::sim
