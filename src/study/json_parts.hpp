// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pieces that JSON documents have in common. An unknown value is null.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "lab/materials/material_library.hpp"

namespace triax::study {

using Json = nlohmann::ordered_json;

/// Null too for infinity and NaN.
Json json_number(const std::optional<double>& value);
/// Pa in kPa, with the shortest digits that stand for this value.
Json json_kPa(const std::optional<double>& pa);
/// rad in degrees.
Json json_deg(const std::optional<double>& rad);
/// Null for an empty text.
Json json_text(const std::string& value);
/// The material of something simulated: name, law and how far the numbers reach.
Json json_material(const lab::MaterialSet& material);
/// The document as it is printed, its line ended.
std::string json_document(const Json& document);
/// The same in one line that is not ended, for programs.
std::string json_line(const Json& document);

}  // namespace triax::study
