// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The grid of states of a bifurcation domain: as it is where nothing is said, and as it is asked
// for.
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

/// What is asked for.
struct GridWish {
  GridLine p, q;
  double void_ratio = 0;
  std::string plane;
  int directions = 0;
  std::vector<std::string> criteria;  ///< beside those that are looked for always
};
/// What stands before a plane and before a criterion where they are refused, as "--plane ", "--".
struct GridWords {
  std::string plane, criterion;
};
/// The criteria of the grid are those of sim::domain_criterion_kinds() that are looked for always
/// and that the law can be asked for, and those of the wish. Throws lab::BadInput for a grid that
/// is not possible, or a plane or criterion that the law cannot be asked for.
DomainSettings::Grid asked_grid(const lab::MaterialSet& material, const GridWish& wish,
                                const GridWords& words);

}  // namespace triax::study
