// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/strain_paths_figures.hpp"

#include <fmt/format.h>

#include "src/probe/figures/strain_paths_figure.hpp"

namespace triax::src {

FigureData strain_paths_data(const study::StrainPathsResult& result) {
  FigureData data{.title = "proportional strain paths, " + result.material.name,
                  .origin = "simulated",
                  .remarks = {"law: " + result.material.law->title,
                              fmt::format("start: p' {:.6g} kPa, isotropic, void ratio {:.6g}",
                                          result.p / 1e3, result.void_ratio)},
                  .columns = {{"R", ""},
                              {"axial_strain", ""},
                              {"control_stress_kPa", "kPa"},
                              {"p_eff_kPa", "kPa"},
                              {"q_kPa", "kPa"},
                              {"eta", ""},
                              {"void_ratio", ""},
                              {"w2_normalised", ""}},
                  .rows = {}};
  for (const auto& path : result.paths)
    for (const auto& at : path.points)
      data.rows.push_back({path.R, at.axial_strain, at.control_stress / 1e3, at.p / 1e3, at.q / 1e3,
                           at.eta(), at.void_ratio, at.normalised_work});
  return data;
}

Drawing strain_paths_drawing(const study::StrainPathsResult& result) {
  return strain_paths_figure(result.paths, {.material = result.material.name,
                                            .state = fmt::format("from p′ = {:.4g} kPa, e = {:.4g}",
                                                                 result.p / 1e3, result.void_ratio),
                                            .plane = sim::ProbePlane::axisymmetric,
                                            .kind = sim::ProbeKind::strain});
}

}  // namespace triax::src
