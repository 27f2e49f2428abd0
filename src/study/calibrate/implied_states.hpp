// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The states at which a calibrated set is asked for its domain, and the sets' answers.
#include <string>
#include <vector>

#include "sim/stability/domain.hpp"
#include "src/study/calibrate/measured_path.hpp"

namespace triax::study {

inline constexpr double kLargestRatioOfDomain = 2.4, kLeastRatioOfDomain = -1.4;

struct ImpliedStates {
  double void_ratio = 0;
  bool of_collapsed = false;
  std::vector<double> pressures;  ///< p′, Pa, rising
  bool extension = false;         ///< whether a test went there
};

/// As implied_domain.hpp says them: seven p′, or three of a law that integrates itself (`finite`).
/// Pre-condition: paths is not empty.
ImpliedStates implied_states(const std::vector<MeasuredPath>& paths, bool finite = false);

/// One column of the domain from isotropic stress to that stress ratio, in rows of 0.05, or 0.2 of
/// a law that integrates itself.
sim::DomainColumn implied_column(const sim::Law<sim::Axisymmetric>& law, double p,
                                 double void_ratio, double ratio);

/// The law's words on a direction that it refuses at a state of the column before a cone opens or
/// the limit is met; empty: it answers them all.
std::string refused_direction(const sim::Law<sim::Axisymmetric>& law,
                              const sim::DomainColumn& column, double void_ratio);

}  // namespace triax::study
