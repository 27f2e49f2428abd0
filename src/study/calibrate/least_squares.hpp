// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Levenberg and Marquardt's method (Ceres' TinySolver) on the residuals of the tests, with
// derivatives by differences of the driver. Beside them stand, per unknown, the distance from the
// possible points over kOutside, which points back inside, and that from what is known beforehand
// over its error.
#include <functional>

#include "src/study/calibrate/misfit.hpp"

namespace triax::study {

struct Residuals {
  Eigen::VectorXd values;    ///< those of the tests, the bounds, the priors
  Eigen::MatrixXd jacobian;  ///< per unknown; empty where not asked for
};

/// At a possible point; central differences of this size, one-sided at a bound and along a path
/// that the law drives to its end at the point and refuses beside it: the penalty of a refusal is
/// no slope of the law.
Residuals residuals_with_slopes(const Misfit& misfit, const Unknowns& x, double step = 1e-3);

struct LocalOptimum {
  Unknowns x;      ///< possible
  double sum = 0;  ///< Σ r² of tests and priors
  int iterations = 0;
};

/// From a point downhill. `go_on` is asked before every evaluation and stops it by false: the best
/// point until then is returned.
LocalOptimum least_squares(const Misfit& misfit, const Unknowns& from, int most_iterations,
                           const std::function<bool()>& go_on);

}  // namespace triax::study
