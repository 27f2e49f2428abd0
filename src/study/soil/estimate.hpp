// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A number that was measured, with what is known of its error.

namespace triax::study {

/// A value with its standard error and the interval that holds the truth with 95 %. In the unit of
/// the value.
struct Estimate {
  double value = 0;
  double error = 0;          ///< standard error; 0: held, or nothing known of it
  double low = 0, high = 0;  ///< 95 %
  int tests = 0;             ///< that it rests on
  bool holds(double truth) const { return low <= truth && truth <= high; }
};

/// t with P(|T| ≤ t) = 0.95 of Student's distribution. Pre-condition: degrees ≥ 1.
double t_of_95(double degrees);
/// The chance of a |T| as large as this or larger. Pre-condition: degrees ≥ 1.
double chance_beyond(double t, double degrees);

/// value ± t(degrees) error.
Estimate estimate(double value, double error, double degrees, int tests);
/// A value of one test whose error is known: value ± 1.96 error.
Estimate measured(double value, double error);

/// The friction angle (degrees) of a stress ratio q/p′ > 0, sin φ = 3M/(6 + M) in compression,
/// 3M/(6 − M) in extension; the ends of the interval go the same way.
Estimate friction_angle(const Estimate& stress_ratio, bool extension);

}  // namespace triax::study
