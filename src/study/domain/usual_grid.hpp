// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The grid of states that a bifurcation domain of a material has where nothing else is said.
#include "src/study/domain/domain_report.hpp"

namespace triax::study {

/// Equal steps from one stress to another, kPa.
struct GridLine {
  double from = 0, to = 0;
  int count = 200;
};

/// p′ that the set is for, within the stresses of the triaxial tests that are usual.
GridLine usual_p(const lab::MaterialSet& material);

/// q from isotropic stress to the critical stress ratio at the highest p′.
GridLine usual_q(const lab::MaterialSet& material, const GridLine& p);

/// The criteria of sim::domain_criterion_kinds() that the law can be asked for, by name: those that
/// are looked for always and those `asked` for. Pre-condition: the material has a law for the plane
/// of the grid.
std::vector<std::string> possible_criteria(const lab::MaterialSet& material,
                                           const DomainSettings::Grid& grid,
                                           const std::vector<std::string>& asked);

}  // namespace triax::study
