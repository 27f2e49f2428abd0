#include "lab/programmes/material_library.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "lab/records/bad_input.hpp"
#include "lab/records/embedded.hpp"
#include "lab/records/text.hpp"
#include "lab/records/toml_reader.hpp"

namespace triax::lab {
namespace {

struct ParameterKey {
  std::string_view key;
  double sim::SanisandParameters::*member;
  double scale = 1;
};

constexpr auto kKeys = std::to_array<ParameterKey>({
    {"shear_modulus_factor", &sim::SanisandParameters::shear_modulus_factor},
    {"poisson_ratio", &sim::SanisandParameters::poisson_ratio},
    {"critical_stress_ratio", &sim::SanisandParameters::critical_stress_ratio},
    {"extension_ratio", &sim::SanisandParameters::extension_ratio},
    {"critical_void_ratio", &sim::SanisandParameters::critical_void_ratio},
    {"critical_slope", &sim::SanisandParameters::critical_slope},
    {"critical_exponent", &sim::SanisandParameters::critical_exponent},
    {"yield_radius", &sim::SanisandParameters::yield_radius},
    {"hardening_factor", &sim::SanisandParameters::hardening_factor},
    {"hardening_void_ratio_factor", &sim::SanisandParameters::hardening_void_ratio_factor},
    {"bounding_exponent", &sim::SanisandParameters::bounding_exponent},
    {"dilatancy_factor", &sim::SanisandParameters::dilatancy_factor},
    {"dilatancy_exponent", &sim::SanisandParameters::dilatancy_exponent},
    {"fabric_limit", &sim::SanisandParameters::fabric_limit},
    {"fabric_rate", &sim::SanisandParameters::fabric_rate},
    {"atmospheric_pressure_kPa", &sim::SanisandParameters::atmospheric_pressure_pa, 1e3},
});

MaterialSet read_set(const TomlTable& table, const std::string& name) {
  MaterialSet set;
  set.name = name;
  set.description = table.text("description").value_or("");
  set.source = table.text("source").value_or("");
  set.range = table.text("range").value_or("");
  for (const ParameterKey& key : kKeys)
    set.parameters.*key.member = key.scale * table.required_number(key.key);
  table.finish();
  try {
    const sim::Sanisand law(set.parameters);
  } catch (const std::invalid_argument& error) {
    table.fail("", fmt::format("the set {}: {}", name, error.what()));
  }
  return set;
}

}  // namespace

std::vector<MaterialSet> read_materials(std::string_view toml_text, const std::string& file) {
  const TomlTable root = TomlTable::parse(toml_text, file);
  const std::string law = root.required_text("law");
  if (law != "sanisand") root.fail("law", excerpt(law) + " is no law; known: sanisand");
  const TomlTable sets = root.required_table("sets");
  root.finish();
  std::vector<MaterialSet> found;
  for (const std::string& key : sets.keys())
    found.push_back(read_set(sets.required_table(key), fmt::format("{}/{}", law, key)));
  if (found.empty()) throw BadInput(file, 0, "holds no set; write [sets.NAME]");
  return found;
}

std::vector<MaterialSet> shipped_materials() {
  std::vector<MaterialSet> all;
  for (const EmbeddedFile& file : kShippedMaterials)
    for (MaterialSet& set : read_materials(file.text, std::string(file.name) + ".toml"))
      all.push_back(std::move(set));
  return all;
}

MaterialSet find_material(std::string_view name, const std::vector<MaterialSet>& sets) {
  std::vector<std::string> names;
  for (const MaterialSet& set : sets) {
    if (set.name == name) return set;
    names.push_back(set.name);
  }
  throw BadInput(fmt::format("no material {}; {}", excerpt(name), suggestion(name, names)));
}

MaterialSet find_material(std::string_view name) {
  return find_material(name, shipped_materials());
}

}  // namespace triax::lab
