// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/trend_filter.hpp"

#include <cmath>

namespace triax::lab {

void TrendFilter::start(double level, double rate) {
  level_ = level;
  rate_ = rate;
}

void TrendFilter::take(double value, double dt_s) {
  const double keep = std::exp(-dt_s / time_constant_s_);
  const double off = value - expected(dt_s);
  level_ = expected(dt_s) + (1 - keep * keep) * off;
  rate_ += (1 - keep) * (1 - keep) * off / dt_s;
}

}  // namespace triax::lab
