// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Proportional strain paths of a law from an isotropic state (Fig. 16 of the paper).
#include <string>
#include <vector>

#include "lab/materials/material_library.hpp"
#include "sim/stability/strain_paths.hpp"

namespace triax::study {

struct StrainPathsRequest {
  lab::MaterialSet material;
  double p = 0;  ///< effective, at the start, Pa
  double void_ratio = 0;
  std::vector<double> R;       ///< of dε₁ + 2R dε₃ = 0, a path each; every one > 0
  double axial_strain = 0.05;  ///< to which the paths go
};

struct StrainPathsResult {
  lab::MaterialSet material;
  double p = 0, void_ratio = 0;  ///< at the start; Pa, 1
  double axial_strain = 0;       ///< to which the paths were to go
  std::vector<sim::StrainPath> paths;
  std::vector<std::string> warnings;
};

/// Throws lab::BadInput where the law refuses the start or has no form in axisymmetry.
StrainPathsResult strain_paths(const StrainPathsRequest& request);

}  // namespace triax::study
