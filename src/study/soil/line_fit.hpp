// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A straight line, or a mean, of points with errors in both axes and a scatter of their own.
#include <optional>
#include <vector>

#include "src/study/soil/estimate.hpp"

namespace triax::study {

/// A point of one test with the standard errors of its measurement.
struct FitPoint {
  double x = 0, y = 0;
  double x_error = 0, y_error = 0;
  double correlation = 0;  ///< of the two errors, −1 to 1
  /// Share of the scatter s that moves the point along x, by s/b, and not along y: of tests whose y
  /// is prescribed and whose x follows.
  double scatter_along_x = 0;
};

/// y = a + b x by the least squares of York et al. (2004), Am. J. Phys. 72:367: errors in both
/// axes,
///
///   W_i = 1/(σ_y² + s² + b² σ_x² − 2 b r σ_x σ_y),   Σ W_i (y_i − a − b x_i)² → min.
///
/// The scatter s between tests, which the errors of measurement do not tell, is that with which
/// the sum becomes n − 2 (Paule and Mandel, 1982), 0 where it is less already. The covariance is
/// multiplied by sum/(n − 2) then, and intervals are those of Student's t with n − 2 degrees
/// (Knapp and Hartung, 2003): they hold whether the errors given are right or too large, and grow
/// as tests become few.
struct LineFit {
  double a = 0, b = 0;
  double var_a = 0, var_b = 0, cov_ab = 0;
  double scatter = 0;  ///< s, in the unit of y
  double x_low = 0, x_high = 0;
  int tests = 0;
  double degrees() const { return tests - 2; }
  double at(double x) const { return a + b * x; }
  double error_at(double x) const;  ///< standard error of the line there
  Estimate line_at(double x) const;
  Estimate intercept() const { return line_at(0); }
  Estimate slope() const;
  double correlation() const;  ///< of a and b
};

/// Nothing for fewer than three points, or where their x do not differ.
std::optional<LineFit> fit_line(const std::vector<FitPoint>& points);
/// The same with a scatter that is known.
std::optional<LineFit> fit_line_with_scatter(const std::vector<FitPoint>& points, double scatter);
/// Σ W_i r_i² of the line.
double weighted_residuals(const LineFit& line, const std::vector<FitPoint>& points);

/// The mean of y likewise, x left out. Its variance is taken from the residuals r themselves, since
/// errors that are too large for some tests would make it too small: with shares v_i = W_i/ΣW,
///
///   Var = Σ v_i² r_i²/(1 − v_i),   1/Σ v_i² − 1 degrees,
///
/// which for equal weights is s²/n with n − 1 degrees.
struct MeanFit {
  Estimate mean;
  double scatter = 0;
  std::vector<double> shares;  ///< v_i
};
/// Nothing for fewer than two.
std::optional<MeanFit> fit_mean(const std::vector<FitPoint>& points);

}  // namespace triax::study
