// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sets of parameters as the tests leave them possible: points drawn about the best one.
//
//   y = x + √(ν/χ²_ν) L z,   L Lᵀ = C′,   z normal
//   C′ = C − C_E (C_EE + I/12)⁻¹ C_Eᵀ
//
// C is the covariance of the estimate and ν its degrees of freedom (uncertainty.hpp): Student's
// distribution, whose marginal intervals are those that are told of the parameters. E are the
// unknowns that the tests do not determine; they have the variance of an even distribution over
// their range besides, 1/12, so that a direction which the tests leave open goes no farther than
// its range. What falls outside the ranges, and what the law refuses, is drawn anew.
#include <cstdint>
#include <vector>

#include "src/study/calibrate/search_space.hpp"
#include "src/study/calibrate/uncertainty.hpp"

namespace triax::study {

struct ParameterDraws {
  std::vector<Unknowns> points;  ///< possible; fewer than asked for where hardly any is
  int outside = 0;               ///< that left the ranges
  int refused = 0;               ///< that the law refused
};

/// The same points for the same seed, with every standard library. Pre-condition: x is possible.
ParameterDraws draw_parameters(const SearchSpace& space, const Unknowns& x, const Uncertainty& sure,
                               int count, std::uint64_t seed);

/// C′. Exposed for its invariants: an unknown that is determined and correlates with none that is
/// not keeps its variance.
Eigen::MatrixXd bounded_covariance(const Uncertainty& sure);

}  // namespace triax::study
