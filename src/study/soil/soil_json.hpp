// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A soil as one JSON document, and as the TOML that `triax calibrate` starts from: the same values
// under the same names (docs/how-to/soil.md). What the tests do not give is null in JSON, absent in
// TOML.
#include <string>
#include <vector>

#include "src/study/json_parts.hpp"
#include "src/study/soil/soil.hpp"

namespace triax::study {

Json soil_json(const Soil& soil);
/// The document of one, or an array of several.
std::string json_of_soils(const std::vector<Soil>& soils);
/// Throws std::invalid_argument for a list that mixes tables with other values, which TOML cannot.
std::string toml_document(const Json& document);

}  // namespace triax::study
