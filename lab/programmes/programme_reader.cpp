// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/programme_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/grains/grain_specimen.hpp"
#include "lab/programmes/fault_reader.hpp"
#include "lab/programmes/operator_reader.hpp"
#include "lab/programmes/rig_reader.hpp"
#include "lab/programmes/stage_reader.hpp"

namespace triax::lab {
namespace {

void read_test(const TomlTable& table, Programme& programme) {
  programme.name = table.required_text("name");
  programme.type = table.required_text("type");
  programme.seed = static_cast<std::uint64_t>(table.integer("seed", 0).value_or(1));
  table.required_number("scan_interval_s");
  programme.logging = read_logging(table, {});
  table.finish();
}

/// Path of the file that `key` names, which becomes one of the programme's files. The key must be
/// one of kProgrammeFileKeys.
std::optional<std::string> read_file_name(const TomlTable& table, std::string_view key,
                                          Programme& programme) {
  if (!std::ranges::any_of(kProgrammeFileKeys, [&](const ProgrammeFileKey& k) {
        return k.table == table.name() && k.key == key;
      }))
    throw std::logic_error(fmt::format("{}.{} is not in kProgrammeFileKeys", table.name(), key));
  const auto name = table.text(key);
  if (!name) return std::nullopt;
  const auto folder = std::filesystem::path(programme.source).parent_path();
  return programme.files.emplace_back((folder / *name).string());
}

void read_membrane(const TomlTable& table, sim::SpecimenProperties& specimen) {
  const auto thickness = table.number("membrane_thickness_mm", {.above = 0, .at_most = 20});
  const auto modulus = table.number("membrane_modulus_kPa", {.above = 0, .at_most = 1e6});
  if (thickness.has_value() != modulus.has_value())
    table.fail(thickness ? "membrane_thickness_mm" : "membrane_modulus_kPa",
               std::string("needs ") +
                   (thickness ? "membrane_modulus_kPa" : "membrane_thickness_mm") +
                   " as well: the membrane's stiffness is their product");
  specimen.membrane_thickness_m = 1e-3 * thickness.value_or(0);
  specimen.membrane_young_modulus_pa = 1e3 * modulus.value_or(0);
  specimen.membrane_penetration_m =
      1e-3 *
      table.number("membrane_penetration_mm3_per_mm2", {.at_least = 0, .at_most = 10}).value_or(0);
}

void read_material(const TomlTable& table, Programme& programme) {
  const std::string material = table.required_text("material");
  const auto file = read_file_name(table, "material_file", programme);
  try {
    programme.material = file
                             ? find_material(material, read_materials(read_text_file(*file), *file))
                             : find_material(material);
  } catch (const BadInput& error) {
    if (file) throw;
    table.fail("material", error.what());
  }
  programme.void_ratio = table.required_number("void_ratio", {.at_least = 0.05, .at_most = 20});
  programme.initial_effective_stress_pa =
      1e3 * table.required_number("initial_effective_stress_kPa", {.at_least = 1, .at_most = 1e4});
  const auto& law = *programme.material.material.axisymmetric;
  if (const auto objection =
          law.objection(law.isotropic(programme.initial_effective_stress_pa, programme.void_ratio)))
    table.fail("void_ratio", *objection);
}

/// Void ratio and stress are those of the grains.
void read_grains(const TomlTable& table, const std::string& path, Programme& programme) {
  for (const char* key :
       {"material", "material_file", "void_ratio", "initial_effective_stress_kPa"})
    if (table.has(key))
      table.fail(
          key,
          "not allowed with grains, which define material, void ratio and stress; leave it out");
  sim::GrainDriving how;
  how.inertial_number = table.number("inertial_number", {.at_least = 1e-6, .at_most = 1e-2})
                            .value_or(how.inertial_number);
  if (const auto angle = table.number("limit_friction_angle_deg", {.at_least = 1, .at_most = 89}))
    programme.limit_friction_angle_rad = sim::radians(*angle);
  const auto law = grain_specimen(path, how);
  programme.void_ratio = law->void_ratio();
  programme.initial_effective_stress_pa = law->pressure_pa();
  programme.material = grain_material(law, path);
}

void read_specimen(const TomlTable& table, Programme& programme) {
  programme.specimen.height_m =
      1e-3 * table.required_number("height_mm", {.at_least = 5, .at_most = 3000});
  programme.specimen.diameter_m =
      1e-3 * table.required_number("diameter_mm", {.at_least = 5, .at_most = 3000});
  read_membrane(table, programme.specimen);
  programme.specimen.saturation =
      table.number("saturation", {.at_least = 0.5, .at_most = 1}).value_or(1);
  programme.specific_gravity = table.number("specific_gravity", {.at_least = 1, .at_most = 10});
  if (const auto grains = read_file_name(table, "grains", programme))
    read_grains(table, *grains, programme);
  else
    read_material(table, programme);
  table.finish();
}

}  // namespace

std::optional<std::string> find_file_key(const TomlTable& document) {
  for (const auto& [table, key] : kProgrammeFileKeys)
    if (document.is_table(table) && document.table(table)->has(key))
      return fmt::format("{}.{}", table, key);
  return std::nullopt;
}

Programme read_programme(std::string_view toml_text, const std::string& file,
                         const std::vector<TomlEdit>& edits) {
  const TomlTable root = TomlTable::parse(toml_text, file, 1, edits);
  Programme programme;
  programme.source = file;
  programme.files = {file};
  const TomlTable test = root.required_table("test");
  const TomlTable specimen = root.required_table("specimen");
  const TomlTable rig = root.required_table("rig");
  const auto stages = root.tables("stages");
  programme.operator_actions = read_operator(root.tables("operator"));
  const auto faults = root.tables("faults");
  const auto guard = root.table("guard");
  root.finish();
  read_test(test, programme);
  read_specimen(specimen, programme);
  read_rig(rig, programme);
  for (const TomlTable& fault : faults) programme.faults.push_back(read_fault(fault, programme));
  if (stages.empty()) throw BadInput(file, 0, "no stage is given; write [[stages]]");
  double cell_pa = programme.initial_back_pressure_pa + programme.initial_effective_stress_pa;
  double back_pa = programme.initial_back_pressure_pa;
  for (const TomlTable& stage : stages)
    programme.stages.push_back(read_stage(stage, programme, cell_pa, back_pa));
  if (guard) programme.guard = read_guard(*guard, programme);
  return programme;
}

Programme load_programme(const std::string& path, const std::vector<TomlEdit>& changes) {
  Programme programme = read_programme(read_text_file(path), path, changes);
  programme.changes = changes;
  return programme;
}

void name_after_changes(Programme& programme) {
  std::string changes;
  for (const TomlEdit& edit : programme.changes)
    changes +=
        (changes.empty() ? "" : ", ") + edit.key.substr(edit.key.rfind('.') + 1) + ' ' + edit.value;
  if (!changes.empty()) programme.name += " [" + changes + ']';
}

}  // namespace triax::lab
