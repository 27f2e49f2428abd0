#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "sim/materials/laws.hpp"

namespace triax::lab {

/// A named parameter set of a law, with where it comes from and how far it reaches.
struct MaterialSet {
  std::string name;  ///< "sanisand/S28-general"
  std::string description;
  std::string source;  ///< of the numbers, and who calibrated them on what
  std::string range;
  const sim::LawDescription* law = nullptr;
  sim::ParameterSet parameters;
  sim::Material material;
};

/// The sets of one TOML file. `file` is what error messages call it and what names of files among
/// the parameters are relative to. Throws BadInput (file:line).
std::vector<MaterialSet> read_materials(std::string_view toml_text, const std::string& file);

/// All sets that ship with the program.
const std::vector<MaterialSet>& shipped_materials();

/// The shipped set of that name; throws BadInput that lists the known ones and the nearest.
MaterialSet find_material(std::string_view name);
/// The same within `sets`.
MaterialSet find_material(std::string_view name, const std::vector<MaterialSet>& sets);

/// The set with one parameter changed, `key` as in its file; its name says so. Throws BadInput.
MaterialSet with_parameter(const MaterialSet& set, const std::string& key,
                           const std::string& value);

}  // namespace triax::lab
