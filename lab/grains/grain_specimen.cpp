#include "lab/grains/grain_specimen.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <span>
#include <stdexcept>
#include <utility>

#include "lab/records/bad_input.hpp"
#include "lab/records/byte_source.hpp"
#include "sim/grains/grain_bytes.hpp"
#include "sim/grains/guarded_steps.hpp"

namespace triax::lab {

sim::GrainState read_grain_file(const std::string& path) {
  const auto source = open_file(path);
  std::string bytes(static_cast<std::size_t>(source->size()), '\0');
  std::size_t size = 0;
  while (size < bytes.size()) {
    const auto count = source->read({bytes.data() + size, bytes.size() - size});
    if (count == 0) break;
    size += count;
  }
  try {
    return sim::load_grains(std::as_bytes(std::span(bytes.data(), size)));
  } catch (const std::invalid_argument& error) {
    throw BadInput(path, 0, error.what());
  }
}

std::shared_ptr<const sim::GrainLaw> grain_specimen(const std::string& path,
                                                    const sim::GrainDriving& how) {
  try {
    return std::make_shared<const sim::GrainLaw>(read_grain_file(path), how);
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
