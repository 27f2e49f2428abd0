// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/materials/laws.hpp"

namespace triax::lab {

/// Values from `low` to `high`, both included.
struct ValidRange {
  double low = 0, high = 0;
  bool holds(double value) const;  ///< to round-off
};

/// A named parameter set of a law, with where it comes from and how far it reaches.
struct MaterialSet {
  std::string name;  ///< "sanisand/S28-general"
  std::string description;
  std::string source;  ///< of the numbers, and who calibrated them on what
  std::string range;   ///< in words
  std::optional<ValidRange> void_ratio_range;
  std::optional<ValidRange> p_eff_range_kPa;
  const sim::LawDescription* law = nullptr;
  sim::ParameterSet parameters;
  sim::Material material;
};

/// The sets of one TOML file. `file` is what error messages call it and what names of files among
/// the parameters are relative to. Throws BadInput (file:line).
std::vector<MaterialSet> read_materials(std::string_view toml_text, const std::string& file);

/// All sets that ship with the program.
const std::vector<MaterialSet>& shipped_materials();

/// "void ratio is 1.3, outside the range 0.7 to 1.2 of inl2/S28-general"; empty where it is
/// within, or no range is known.
std::optional<std::string> void_ratio_outside(const MaterialSet& set, double void_ratio);
/// The same of p' (Pa).
std::optional<std::string> p_eff_outside(const MaterialSet& set, double p_eff_pa);

/// The shipped set of that name; throws BadInput that lists the known ones and the nearest.
MaterialSet find_material(std::string_view name);
/// The same within `sets`.
MaterialSet find_material(std::string_view name, const std::vector<MaterialSet>& sets);

/// The law of the set once more, for another thread: nothing that changes while it is asked is
/// shared with the set's own (a UMAT has another worker process). Throws std::invalid_argument.
sim::Material made_anew(const MaterialSet& set);

/// The set with one parameter changed, `key` as in its file; its name says so. Throws BadInput.
MaterialSet with_parameter(const MaterialSet& set, const std::string& key,
                           const std::string& value);

}  // namespace triax::lab
