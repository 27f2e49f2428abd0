// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How the text of something simulated begins.
#include <string>

#include "lab/materials/material_library.hpp"

namespace triax::src {

/// A label and its value on one line; nothing for an empty value.
[[nodiscard]] std::string fact(const std::string& label, const std::string& value);

/// What a head says of the material.
struct HeadOfMaterial {
  std::string name, law, based_on, source, range;
};

/// "TITLE, LAW/SET (simulated)" underlined, and what the material is.
[[nodiscard]] std::string simulated_head(const std::string& title, const HeadOfMaterial& material);
[[nodiscard]] std::string simulated_head(const std::string& title,
                                         const lab::MaterialSet& material);

}  // namespace triax::src
