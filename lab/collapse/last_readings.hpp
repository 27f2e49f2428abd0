// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The end of a path before a fall: parabolas through its last readings, and what they leave open.
#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "lab/measured/path_rates.hpp"

namespace triax::lab {

/// Least squares of y over three terms.
struct ThreeTerms {
  Eigen::Vector3d c = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double scatter = 0;  ///< standard deviation of one y
  /// Pre-condition: more than three of them.
  ThreeTerms(const std::vector<Eigen::Vector3d>& terms, const std::vector<double>& y);
};

/// A quantity at the last reading, and its change from one reading to the next there: the parabola
/// through the last few.
struct AtLast {
  double value = 0, rate = 0, bend = 0, value_error = 0, rate_error = 0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double scatter = 0;  ///< standard deviation of a reading
  /// Back along the readings, or ahead.
  double before(double readings) const { return value + readings * (rate + readings * bend); }
  double rate_at(double readings) const { return rate + 2 * readings * bend; }
  double error_at(double readings) const;
  double rate_error_at(double readings) const;
};

/// Pre-condition: at least four samples.
AtLast at_last(std::span<const PathSample> samples,
               const std::function<double(const PathSample&)>& value, std::size_t readings);
AtLast at_last(std::span<const PathSample> samples, PathSample::Signal signal,
               std::size_t readings);

/// From the last readings back, as far as a signal may have turned there: its slope cannot be told
/// from zero (Fieller). Of parabolas through more or fewer readings the one whose slope is known
/// best.
struct Turned {
  double first = 1, last = 0;  ///< readings from the last one
  std::size_t of = 0;          ///< readings that tell
  bool anywhere() const { return first <= last; }
};
/// Nowhere for fewer than six samples.
Turned may_have_turned(std::span<const PathSample> samples, PathSample::Signal signal);

/// At held q: whether p′ falls and the specimen contracts at the last of them, by
/// ChangePoint::kSignificance standard errors: in the volume if `drained`, else in the pore
/// pressure, which measures it while the valve is closed. False for fewer than six samples.
bool contracts_at_end(std::span<const PathSample> samples, bool drained);

/// Whether second-order work dq dε_q + dp′ dε_v at the last of them is negative by
/// ChangePoint::kSignificance standard errors, while the axis moves on: at half of `mean_rate`, the
/// axial strain per reading of the stage, or more. False for fewer than six samples.
bool softens_at_end(std::span<const PathSample> samples, double mean_rate);

/// Whether q grows up to the end as it did over the stage, by `rate_of_stage` a reading, as under a
/// load: over as few of the last readings as tell. Pre-condition: at least four samples.
bool grows_steadily(std::span<const PathSample> samples, double rate_of_stage);

}  // namespace triax::lab
