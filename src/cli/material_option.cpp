// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/material_option.hpp"

#include <fmt/format.h>

#include <CLI/Option.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/paths/path_reader.hpp"
#include "src/cli/shared_options.hpp"

namespace triax::src {

void add_material(CLI::App& app, MaterialOptions& options) {
  app.add_option("--material", options.name, "parameter set, as listed by triax materials")
      ->type_name("LAW/SET");
  app.add_option(
         "--materials", options.file,
         "use the sets of this parameter file (also for a UMAT) instead of the shipped sets")
      ->type_name("FILE.toml");
  app.add_option("--set", options.sets, "set a parameter of the law (repeatable)")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  app.add_option("--void-ratio", options.void_ratio, "void ratio of the states")->type_name("E");
}

lab::MaterialSet chosen_material(const MaterialOptions& options) {
  if (options.name.empty())
    throw lab::BadInput(
        "missing --material LAW/SET, as in --material inl2/S28-general; `triax materials` lists "
        "all sets");
  lab::MaterialSet material =
      options.file.empty()
          ? lab::find_material(options.name)
          : lab::find_material(
                options.name, lab::read_materials(lab::read_text_file(options.file), options.file));
  for (const auto& [key, value] : key_values(options.sets, "hardening_factor=2"))
    material = lab::with_parameter(material, key, value);
  return material;
}

double chosen_void_ratio(const MaterialOptions& options, const lab::MaterialSet& material) {
  if (!options.void_ratio) {
    const auto& range = material.void_ratio_range;
    throw lab::BadInput(
        "missing --void-ratio E" +
        (range ? fmt::format("; {} is for {:g} to {:g}", material.name, range->low, range->high)
               : std::string()));
  }
  const double e = *options.void_ratio;
  if (!(e >= lab::kSmallestVoidRatio && e <= lab::kLargestVoidRatio))
    throw lab::BadInput(
        fmt::format("--void-ratio {:g}: out of range; expected a number from {:g} to {:g}", e,
                    lab::kSmallestVoidRatio, lab::kLargestVoidRatio));
  return e;
}

}  // namespace triax::src
