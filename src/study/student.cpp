// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/student.hpp"

#include <boost/math/distributions/students_t.hpp>

namespace triax::study {

double student_quantile(double degrees_of_freedom, double confidence) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), (1 + confidence) / 2);
}

}  // namespace triax::study
