// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/straight_line.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {

void StraightLine::add(double x, double y, double sigma, double share) {
  const double w = share / (sigma * sigma);
  ++points_;
  shares_ += share;
  w_ += w;
  const double dx = x - x_, dy = y - y_;
  x_ += dx * w / w_;
  y_ += dy * w / w_;
  xx_ += w * dx * (x - x_);
  xy_ += w * dx * (y - y_);
  yy_ += w * dy * (y - y_);
}

std::optional<StraightLine::Zero> StraightLine::zero() const {
  if (points_ < 3 || !(xx_ > 0)) return std::nullopt;
  const double slope = xy_ / xx_;
  if (!(slope < 0)) return std::nullopt;
  const double from_mean = -y_ / slope;
  const double scatter = std::max(yy_ - slope * xy_, 0.0) / std::max(shares_ - 2, 1.0);
  const double variance =
      std::max(scatter, 1.0) * (1 / w_ + from_mean * from_mean / xx_) / (slope * slope);
  return Zero{x_ + from_mean, std::sqrt(variance)};
}

}  // namespace triax::lab
