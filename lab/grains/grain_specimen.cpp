// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_specimen.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/grains/grain_files.hpp"
#include "sim/grains/engine/guarded_steps.hpp"

namespace triax::lab {

std::shared_ptr<const sim::GrainLaw> grain_specimen(const std::string& path,
                                                    const sim::GrainDriving& how) {
  try {
    return std::make_shared<const sim::GrainLaw>(load_state(path), how);
  } catch (const std::invalid_argument& error) {
    throw BadInput(path, 0, error.what());
  } catch (const sim::GrainsFailed& error) {
    throw BadInput(path, 0, error.what());
  }
}

MaterialSet grain_material(std::shared_ptr<const sim::GrainLaw> law, const std::string& path) {
  MaterialSet set;
  set.name =
      fmt::format("{} spheres, {}", law->grains(), std::filesystem::path(path).filename().string());
  set.description = "spheres in a box of six walls, the homogeneous element of the specimen";
  set.source = path;
  set.material.no_tensor = "the grains stand between the walls of a box";
  set.material.axisymmetric = std::move(law);
  return set;
}

}  // namespace triax::lab
