// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// --material, --materials, --set and --void-ratio: the material of a command that needs no path
// file, each option written once.
#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lab/materials/material_library.hpp"

namespace triax::src {

struct MaterialOptions {
  std::string name;               ///< LAW/SET; empty: not given
  std::string file;               ///< of sets of the user's own; empty: the shipped ones
  std::vector<std::string> sets;  ///< KEY=VALUE, parameters of the law
  std::optional<double> void_ratio;
};

/// Adds the four options; none of them is required of the parser, since a command may have another
/// source for them (a test, a piece).
void add_material(CLI::App& app, MaterialOptions& options);

/// The set with its parameters changed. Throws lab::BadInput where none is named, it is not known,
/// or a parameter does not fit.
lab::MaterialSet chosen_material(const MaterialOptions& options);

/// The void ratio; throws lab::BadInput where it is not given or is none a soil can have.
double chosen_void_ratio(const MaterialOptions& options, const lab::MaterialSet& material);

}  // namespace triax::src
