// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tests that do not belong to the others of a fit.
#include <cstddef>
#include <limits>
#include <vector>

namespace triax::study {

struct OddTest {
  std::size_t index = 0;  ///< among the points
  double residual = 0;    ///< from what the others give, in the unit of y
  double deviations = 0;  ///< residual in standard deviations
};

/// A test beside the others: y = a + Σ b_k x_k.
struct JudgedPoint {
  double y = 0, y_error = 0;         ///< standard error of its measurement
  std::vector<double> x, x_error;    ///< of equal size; none: a mean is asked
  double usual = 0, usual_of_x = 0;  ///< standard deviations of repeated tests of a good
                                     ///< laboratory, of y and of the first x
  bool judged = true;                ///< false: it is one of the others only
};

inline constexpr double kUnknownSlope = std::numeric_limits<double>::infinity();

/// The tests under one form of the relation that may hold.
struct JudgedForm {
  std::vector<JudgedPoint> points;
  /// What is known of each b_k before any test, as a standard deviation about 0.
  std::vector<double> usual_slopes;
};

/// The points that lie so far from the fit through the others that chance does it in less than one
/// fit of ten (Student's t of the deleted residual, divided among the points); the worst is
/// taken out, then the rest is asked again, no more than a third of them in all.
///
///   v_i = σ_y² + usual² + Σ b_k² σ_xk² + b_1² usual_of_x²
///   b   : Σ r_j²/v_j + Σ b_k²/s_k² least, s_k the usual slopes
///   f   = (Σ r_j²/v_j + 10)/(m − p + 10)
///   t   = r_i/√(f (v_i + var of the fit there)),   m − p + 10 degrees,
///
/// of the m others, p numbers of which nothing is known.
///
/// What is usual counts as ten tests: three tests that happen to lie on one line condemn no
/// fourth, and of many tests their own scatter decides. A curvature or a cohesion of which the
/// usual size is known makes the others' fit unsure where they do not reach, and no more: so a few
/// tests judge, and the first and the last of a row are judged.
///
/// `forms`: the same points under each form of the relation that may hold (x differs). Of the forms
/// that the others leave open (Akaike's criterion), that one counts in which the test is least odd;
/// a form for which the others are too few leaves all open, and none is judged. Pre-condition: at
/// least one form.
std::vector<OddTest> odd_tests(const std::vector<JudgedForm>& forms);

}  // namespace triax::study
