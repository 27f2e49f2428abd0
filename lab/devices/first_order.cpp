// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/first_order.hpp"

#include <cmath>

namespace triax::lab {

double first_order(double y, double x_start, double x_end, double dt_s, double time_constant_s) {
  if (time_constant_s == 0) return x_end;
  if (dt_s == 0) return y;
  const double ratio = dt_s / time_constant_s;
  const double part = -std::expm1(-ratio);
  return y + part * (x_start - y) + (1 - part / ratio) * (x_end - x_start);
}

}  // namespace triax::lab
