// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a calibrated set implies of stability: the bifurcation domain and its cones, and how far the
// tests leave them open.
//
// The law with the best parameters, and with each of many sets drawn from their estimate
// (parameter_draws.hpp), is asked as triax domain asks it (sim/stability/domain.hpp): at one void
// ratio and some p′, going away from q = 0, where W₂ first vanishes in a direction of the
// axisymmetric plane, where in isotropic unloading, and where the plastic limit is. At some states
// inside the domain of the best set it is asked for its cone. Of each number the middle 95 % of the
// draws that have it are told, and the share of draws that have it.
//
//   e    the median of the tests that collapsed; of all where none did
//   p′   even steps from the least at which a test began to shear or collapsed to the largest that
//        one came to, rounded to three digits
//   η    rows of 0.05 up to 2.4 in compression, and down to −1.4 in extension where a test went
//        there; what is met is isolated between them
//
// A law that integrates itself, such as a UMAT, answers slowly: it is asked at three p′ and in rows
// of 0.2.
//
// Intervals hold what the tests leave open in this law; they do not say that the law is right.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/study/calibrate/misfit.hpp"
#include "src/study/calibrate/uncertainty.hpp"

namespace triax::study {

/// A number that follows from the parameters.
struct Implied {
  std::optional<double> best;       ///< of the best set; empty: it has none
  std::optional<double> low, high;  ///< of the draws that have it; empty: too few do
  double share = 0;                 ///< of the draws that have it
};

/// Where criteria are first met at one p′. η = q/p′, below 0 in extension.
struct ImpliedBoundary {
  double p = 0;  ///< Pa
  Implied first_unstable;
  Implied first_angle;  ///< α of the direction in which W₂ vanishes first, rad
  Implied isotropic_unloading;
  Implied limit;
};

/// The cone at a state; of several the widest, and of a draw the one nearest to that. Rendulic
/// angles, rad.
struct ImpliedCone {
  double p = 0, q = 0;  ///< Pa
  Implied from, to;     ///< its first and its last unstable direction
  Implied opening;
};

struct ImpliedDomain {
  double void_ratio = 0;
  bool of_collapsed = false;  ///< the median of the tests that collapsed, not of all
  double confidence = 0.95;
  int draws = 0;    ///< that were computed; none where the law refuses directions
  int asked = 0;    ///< of them
  int refused = 0;  ///< sets that the law refused, which were drawn anew
  std::vector<ImpliedBoundary> compression;
  std::vector<ImpliedBoundary> extension;  ///< empty: no test went there
  std::vector<ImpliedCone> cones;
  /// Why no domain is told, one line; empty: there is one. A law that refuses directions has none
  /// that could be told: the refused ones may be those that are unstable first.
  std::string none;
};

struct ImpliedOptions {
  std::uint64_t seed = 1;
  /// 200 of a law in rates, 10 of one that integrates itself, such as a UMAT: 0.
  int draws = 0;
};

/// `go_on` is told the share that is done, in the caller's thread, and stops by false: empty then.
/// The result does not depend on the number of threads. Pre-condition: x is possible.
std::optional<ImpliedDomain> implied_domain(const Misfit& misfit, const Unknowns& x,
                                            const Uncertainty& sure, const ImpliedOptions& options,
                                            const std::function<bool(double)>& go_on);

}  // namespace triax::study
