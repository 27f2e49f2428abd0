// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Laws and parameter sets, as text and JSON.
#include <string>
#include <vector>

#include "lab/materials/material_library.hpp"

namespace triax::src {

/// Every law with its sets.
std::string materials_text(const std::vector<lab::MaterialSet>& sets);
std::string materials_json(const std::vector<lab::MaterialSet>& sets);
/// One set, parameter by parameter.
std::string material_text(const lab::MaterialSet& set);
std::string material_json(const lab::MaterialSet& set);
/// A law without values: what its parameters are.
std::string law_text(const sim::LawDescription& law);
std::string law_json(const sim::LawDescription& law);

}  // namespace triax::src
