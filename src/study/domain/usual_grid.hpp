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

/// Which of the criteria beyond second-order work the law can be asked for.
struct PossibleCriteria {
  bool determinant = false, localisation = false;
};

/// `localisation` only where the grid asks for it. Pre-condition: the material has a law for the
/// plane of the grid.
PossibleCriteria possible_criteria(const lab::MaterialSet& material,
                                   const DomainSettings::Grid& grid);

}  // namespace triax::study
