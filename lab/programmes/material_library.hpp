#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "sim/materials/sanisand.hpp"

namespace triax::lab {

/// A named parameter set of a law, with where it comes from and how far it reaches.
struct MaterialSet {
  std::string name;  ///< "sanisand/S28-general"
  std::string description;
  std::string source;
  std::string range;
  sim::SanisandParameters parameters;
};

/// The sets of one TOML file. `file` is what error messages call it. Throws BadInput (file:line).
std::vector<MaterialSet> read_materials(std::string_view toml_text, const std::string& file);

/// All sets that ship with the program.
std::vector<MaterialSet> shipped_materials();

/// The shipped set of that name; throws BadInput that lists the known ones and the nearest.
MaterialSet find_material(std::string_view name);
/// The same within `sets`.
MaterialSet find_material(std::string_view name, const std::vector<MaterialSet>& sets);

}  // namespace triax::lab
