// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/log_axis.hpp"

#include <cmath>
#include <vector>

namespace triax::src {
namespace {

constexpr double kBeyond = 1.08, kLeastRatio = 3;

/// Numbered places within a decade for an axis that spans this ratio.
std::vector<double> places(double ratio) {
  if (ratio > 1500) return {1};
  if (ratio > 12) return {1, 2, 5};
  return {1, 1.5, 2, 3, 4, 6, 8};
}

}  // namespace

void set_log_axis(QCPAxis& axis, double low, double high) {
  if (high < kLeastRatio * low) {
    const double middle = std::sqrt(low * high);
    low = middle / std::sqrt(kLeastRatio);
    high = middle * std::sqrt(kLeastRatio);
  }
  low /= kBeyond;
  high *= kBeyond;
  const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
  const auto numbered = places(high / low);
  for (int power = static_cast<int>(std::floor(std::log10(low))); std::pow(10, power) < high;
       ++power)
    for (const double place : numbered)
      if (const double at = place * std::pow(10, power); at >= low && at <= high)
        ticker->addTick(at, QString::number(at, 'g', 6));
  axis.setScaleType(QCPAxis::stLogarithmic);
  axis.setTicker(ticker);
  axis.setRange(low, high);
}

}  // namespace triax::src
