// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A path of one material point with its material: what a path file says, SI.
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lab/materials/material_library.hpp"
#include "sim/point/path.hpp"

namespace triax::lab {

using TriaxialPath = sim::Path<sim::Axisymmetric>;
using TensorPath = sim::Path<sim::Tensor>;

struct PathDescription {
  std::string name;
  std::string source;              ///< file it was read from
  std::vector<std::string> files;  ///< that one, and those that it names
  double tolerance = 1e-8;         ///< sim::PointTolerance::relative

  MaterialSet material;
  std::string material_name;  ///< as it can be found: without changed parameters
  std::string material_file;  ///< of the user's own sets; empty: shipped ones
  std::vector<std::pair<std::string, std::string>> parameters;  ///< changed, key and value

  std::variant<TriaxialPath, TensorPath> path;
  std::vector<std::string>
      warnings;  ///< what a reader must know of the translation of a foreign file
};

/// Throws BadInput where the law has no form in the path's space, refuses the start, or has another
/// number of memory values than the start gives.
void check_start(const PathDescription& description);

/// Throws BadInput where the path, with all repetitions, has more rows of output or more parts
/// (each of them an increment at least) than a run should take.
void check_length(const PathDescription& description);

/// One setting of the command line: material, void_ratio, p_eff_kPa, tolerance, or a parameter of
/// the law. check_start() is to follow. Throws BadInput.
void change_setting(PathDescription& description, const std::string& key, const std::string& value);

}  // namespace triax::lab
