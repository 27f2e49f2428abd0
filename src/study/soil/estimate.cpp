// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/estimate.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/study/student.hpp"

namespace triax::study {
namespace {

double friction_angle_deg(double ratio, bool extension) {
  const double side = extension ? -1 : 1;
  return sim::degrees(std::asin(std::clamp(3 * ratio / (6 + side * ratio), -1.0, 1.0)));
}

}  // namespace

double t_of_95(double degrees) { return student_quantile(degrees, 0.95); }

double chance_beyond(double t, double degrees) {
  return 2 *
         boost::math::cdf(boost::math::complement(boost::math::students_t(degrees), std::abs(t)));
}

Estimate estimate(double value, double error, double degrees, int tests) {
  const double half = t_of_95(degrees) * error;
  return {value, error, value - half, value + half, tests};
}

Estimate measured(double value, double error) {
  constexpr double kNormal = 1.959963985;
  return {value, error, value - kNormal * error, value + kNormal * error, 1};
}

Estimate friction_angle(const Estimate& m, bool extension) {
  const double value = friction_angle_deg(m.value, extension);
  constexpr double kStep = 1e-6;
  const double slope = (friction_angle_deg(m.value + kStep, extension) - value) / kStep;
  return {value, slope * m.error, friction_angle_deg(m.low, extension),
          friction_angle_deg(m.high, extension), m.tests};
}

}  // namespace triax::study
