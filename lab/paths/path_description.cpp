// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/path_description.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/paths/path_reader.hpp"

namespace triax::lab {
namespace {

const std::vector<std::string> kSettings = {"material", "void_ratio", "p_eff_kPa", "tolerance"};

constexpr double kMostRowsOfStage = 2e5;
constexpr double kMostParts = 4e6;

double number_within(const std::string& key, const std::string& value, double lowest,
                     double highest) {
  const auto number = whole_text_as<double>(value);
  if (!number || !(*number >= lowest && *number <= highest))
    throw BadInput(fmt::format("{}={}: must be a number, {} to {}", key, excerpt(value),
                               fmt::to_string(lowest), fmt::to_string(highest)));
  return *number;
}

template <class Space>
void check(const PathDescription& description, const sim::Path<Space>& path) {
  const auto refuse = [&](const std::string& message) {
    throw BadInput(description.source, 0, message);
  };
  const sim::Law<Space>* law = description.material.material.law<Space>();
  if (law == nullptr)
    refuse(fmt::format("{} cannot follow this path: {}", description.material.name,
                       Space::kSize == 6 && !description.material.material.no_tensor.empty()
                           ? description.material.material.no_tensor
                           : "the law is not formulated for the frame of the path"));
  const auto start = law->start(path.stress, path.void_ratio);
  const auto wanted = static_cast<std::size_t>(start.memory.size());
  if (!path.memory.empty() && path.memory.size() != wanted)
    refuse(fmt::format("[start] memory has {} values, {} has {} ({})", path.memory.size(),
                       description.material.name, wanted, joined(law->memory_names())));
  auto state = start;
  for (std::size_t i = 0; i < path.memory.size(); ++i)
    state.memory(static_cast<Eigen::Index>(i)) = path.memory[i];
  if (auto objection = law->objection(state))
    refuse(fmt::format("[start] out of range for {}: {}", description.material.name, *objection));
}

template <class Space>
void check_length_of(const sim::Path<Space>& path, const std::string& source) {
  double rows = 0, parts = 0;
  try {
    for (const std::size_t i : sim::segment_order(path)) {
      rows += path.segments[i].rows;
      parts += sim::parts_of(path.segments[i]);
    }
  } catch (const std::invalid_argument& error) {
    throw BadInput(source, 0, error.what());
  }
  if (rows > kMostRowsOfStage)
    throw BadInput(
        source, 0,
        fmt::format("{:.0f} rows of output with all repetitions; at most {:.0f} are possible: "
                    "lower rows of the segments",
                    rows, kMostRowsOfStage));
  if (parts > kMostParts)
    throw BadInput(
        source, 0,
        fmt::format("{:.0f} parts of segments with all repetitions, each of them at "
                    "least one increment; at most {:.0f} are possible: lower parts (or rows) of "
                    "the segments, or repeat",
                    parts, kMostParts));
}

void change_parameter(PathDescription& description, const std::string& key,
                      const std::string& value) {
  std::vector<std::string> known = kSettings;
  bool found = false;
  for (const auto& parameter : description.material.law->parameters) {
    known.push_back(parameter.key);
    found = found || parameter.key == key;
  }
  if (!found)
    throw BadInput(fmt::format("unknown key {}; {}", excerpt(key), suggestion(key, known)));
  description.material = with_parameter(description.material, key, value);
  description.parameters.emplace_back(key, value);
}

}  // namespace

void check_start(const PathDescription& description) {
  std::visit([&](const auto& path) { check(description, path); }, description.path);
}

void check_length(const PathDescription& description) {
  std::visit([&](const auto& path) { check_length_of(path, description.source); },
             description.path);
}

void change_setting(PathDescription& description, const std::string& key,
                    const std::string& value) {
  if (key == "material") {
    description.material = find_path_material(value, description.material_file, description.source);
    description.material_name = value;
    description.parameters.clear();
  } else if (key == "tolerance") {
    description.tolerance =
        number_within(key, value, kSmallestPathTolerance, kLargestPathTolerance);
  } else if (key == "void_ratio") {
    const double e = number_within(key, value, kSmallestVoidRatio, kLargestVoidRatio);
    std::visit([&](auto& path) { path.void_ratio = e; }, description.path);
  } else if (key == "p_eff_kPa") {
    const double p_pa = 1e3 * number_within(key, value, kSmallestPathStress_kPa, 1e5);
    std::visit(
        [&]<class Space>(sim::Path<Space>& path) {
          if (!path.memory.empty())
            throw BadInput("p_eff_kPa cannot be set: the path starts with a memory of its own");
          path.stress = sim::isotropic<Space>(p_pa);
        },
        description.path);
  } else {
    change_parameter(description, key, value);
  }
}

}  // namespace triax::lab
