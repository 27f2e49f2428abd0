// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/colour_steps.hpp"

#include <algorithm>
#include <cmath>

namespace triax::src {
namespace {

QColor between(const std::vector<QColor>& stops, double position) {
  const double scaled = position * static_cast<double>(stops.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(scaled), stops.size() - 1);
  const auto& from = stops[first];
  const auto& to = stops[std::min(first + 1, stops.size() - 1)];
  const double part = scaled - static_cast<double>(first);
  const auto mixed = [part](int a, int b) {
    return static_cast<int>(std::lround(std::lerp(a, b, part)));
  };
  return {mixed(from.red(), to.red()), mixed(from.green(), to.green()),
          mixed(from.blue(), to.blue())};
}

}  // namespace

std::vector<QColor> steps_between(const std::vector<QColor>& stops, int count) {
  std::vector<QColor> steps;
  for (int i = 0; i < count; ++i) steps.push_back(between(stops, (i + 0.5) / count));
  return steps;
}

QCPColorGradient stepped_gradient(const std::vector<QColor>& steps) {
  constexpr int kFine = 40;  // entries of QCustomPlot's table a step
  constexpr double kJustBelow = 1e-7;
  const auto count = static_cast<double>(steps.size());
  QCPColorGradient gradient;
  gradient.clearColorStops();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    gradient.setColorStopAt(static_cast<double>(i) / count, steps[i]);
    gradient.setColorStopAt(static_cast<double>(i + 1) / count - kJustBelow, steps[i]);
  }
  gradient.setColorStopAt(1, steps.back());
  gradient.setLevelCount(kFine * static_cast<int>(steps.size()) + 1);
  gradient.setNanHandling(QCPColorGradient::nhNanColor);
  gradient.setNanColor(kNoValue);
  return gradient;
}

}  // namespace triax::src
