#pragma once
// Proportional strain paths of a law from an isotropic state (Fig. 16 of the paper), as text, JSON
// and CSV.
#include <string>
#include <vector>

#include "lab/materials/material_library.hpp"
#include "sim/stability/strain_paths.hpp"
#include "src/plot/drawing.hpp"
#include "src/plot/figure_files.hpp"

namespace triax::src {

struct StrainPathsReport {
  lab::MaterialSet material;
  double p = 0;  ///< effective, at the start, Pa
  double void_ratio = 0;
  double axial_strain = 0;  ///< to which the paths go
  std::vector<sim::StrainPath> paths;
  std::vector<std::string> warnings;
};

/// Throws lab::BadInput where the law refuses the start. Pre-condition: every R > 0.
StrainPathsReport strain_paths(const lab::MaterialSet& material, double p, double void_ratio,
                               const std::vector<double>& R, double axial_strain);

std::string strain_paths_text(const StrainPathsReport& report);
std::string strain_paths_json(const StrainPathsReport& report);
FigureData strain_paths_data(const StrainPathsReport& report);
Drawing strain_paths_drawing(const StrainPathsReport& report);

}  // namespace triax::src
