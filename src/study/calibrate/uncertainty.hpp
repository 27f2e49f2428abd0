// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How well the tests determine the parameters.
//
//   C = A⁻¹ B A⁻¹,  A = JᵀJ,  B = Σ_series s² JᵀW R W J + Σ_tests σ_e² g gᵀ
//
// J are the slopes of the unweighted residuals, W their weights, s² the variance of a series'
// residuals and R = ρ^|i−j| their correlation from knot to knot, both taken from the residuals
// themselves: so that neither the many readings of a smooth misfit nor weights that are not those
// of the noise make an interval too narrow. g = JᵀW ∂r/∂e carries the error of each test's void
// ratio. Intervals are those of Student's distribution with as many degrees of freedom as the
// residuals leave.
#include <string>
#include <vector>

#include "src/study/calibrate/least_squares.hpp"

namespace triax::study {

struct ParameterEstimate {
  std::string key;
  double value = 0;          ///< in the units of the file
  double error = 0;          ///< standard error, likewise
  double low = 0, high = 0;  ///< interval, within the range that was searched
  bool determined =
      true;  ///< false: most of its range is open, to a misfit of kAccuracy or to theirs
  bool at_bound = false;
};

struct Uncertainty {
  std::vector<ParameterEstimate> parameters;
  Eigen::MatrixXd covariance;   ///< of the unknowns
  Eigen::MatrixXd correlation;  ///< likewise
  double degrees_of_freedom = 0;
};

struct UncertaintyOptions {
  double confidence = 0.95;
  double void_ratio_error = 0;  ///< standard error of each test's own
};

/// Pre-condition: x is possible and an optimum.
Uncertainty uncertainty_at(const Misfit& misfit, const Unknowns& x,
                           const UncertaintyOptions& options = {});

}  // namespace triax::study
