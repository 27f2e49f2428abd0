// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/energy_axis.hpp"

#include <algorithm>
#include <cmath>

namespace triax::src {

void EnergyRange::add(double energy_j) {
  if (!std::isfinite(energy_j) || energy_j <= 0) return;
  least_ = least_ > 0 ? std::min(least_, energy_j) : energy_j;
  most_ = std::max(most_, energy_j);
}

bool EnergyRange::logarithmic() const { return least_ > 0 && most_ >= 100 * least_; }

void EnergyRange::apply(QCPAxis& axis) const {
  axis.setNumberFormat("gb");
  if (!logarithmic()) {
    axis.setRange(0, most_ > 0 ? 1.06 * most_ : 1);
    return;
  }
  axis.setScaleType(QCPAxis::stLogarithmic);
  axis.setTicker(QSharedPointer<QCPAxisTickerLog>(new QCPAxisTickerLog));
  axis.setNumberFormat("eb");
  axis.setNumberPrecision(0);
  axis.setRange(std::pow(10, std::floor(std::log10(least_))),
                std::pow(10, std::ceil(std::log10(most_))));
}

}  // namespace triax::src
