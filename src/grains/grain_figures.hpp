// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "lab/grains/grain_report.hpp"
#include "src/plot/figure_files.hpp"

namespace triax::src {

/// The figures of a run, with the numbers behind them:
///
///   STAGE_envelope, STAGE_work, STAGE_contacts   of each rose (Figs. 13, 14, 15 of the paper)
///   strain_paths                                 all strain paths (Fig. 16)
///   load_steps, energies                         perturbations of one kind side by side (Figs. 17,
///                                                18); loads_and_energies, unperturbed likewise
///   drained, isotropic                           all paths of that kind
///
/// What in a stage's name is no letter, digit, '-' or '.' is '_'. Stages that were not made, or
/// stopped before their first point, are left out, and figures without any. The data of a figure
/// that has nothing drawn do not exist either.
std::vector<NamedFigure> grain_figures(const lab::GrainReport& report);

}  // namespace triax::src
