// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/element/run_element.hpp"

#include <algorithm>

#include "lab/paths/incremental_driver_reader.hpp"
#include "lab/paths/path_reader.hpp"

namespace triax::study {

lab::PathDescription described_path(const std::string& file,
                                    std::vector<std::pair<std::string, std::string>> settings,
                                    const std::optional<lab::MaterialSet>& material) {
  lab::PathDescription description = lab::is_incremental_driver(file)
                                         ? lab::describe_incremental_driver(file, settings)
                                         : lab::load_path(file);
  if (material) {
    description.material = *material;
    description.material_name.clear();
    description.parameters.clear();
  }
  // The material first: parameters are changed in the one that is meant.
  std::stable_partition(settings.begin(), settings.end(),
                        [](const auto& one) { return one.first == "material"; });
  for (const auto& [key, value] : settings) lab::change_setting(description, key, value);
  lab::check_start(description);
  return description;
}

PathResult run_element(const lab::PathDescription& description, const Progress& progress) {
  const auto run = [&]<class Space>(const sim::Path<Space>& path) {
    const auto result = sim::run_path(
        *description.material.material.law<Space>(), path,
        {.tolerance = {.relative = description.tolerance}, .progress = [&](double share) {
           show(progress, description.name, share);
           return true;
         }});
    return path_result(description, result);
  };
  return std::visit(run, description.path);
}

}  // namespace triax::study
