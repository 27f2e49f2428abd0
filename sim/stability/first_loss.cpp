#include "sim/stability/first_loss.hpp"

#include <cmath>

namespace triax::sim {

std::optional<double> first_loss(const Criterion& criterion, double from, double to,
                                 const LossOptions& options) {
  const auto lost = [&criterion](double at) {
    const auto value = criterion(at);
    return value && *value <= 0;
  };
  if (lost(from)) return from;
  double before = from;
  for (int i = 1; i <= options.steps; ++i) {
    double beyond = from + (to - from) * i / options.steps;
    if (!lost(beyond)) {
      before = beyond;
      continue;
    }
    while (std::abs(beyond - before) > options.precision * std::abs(to - from)) {
      const double middle = (before + beyond) / 2;
      if (middle == before || middle == beyond) break;
      (lost(middle) ? beyond : before) = middle;
    }
    return beyond;
  }
  return std::nullopt;
}

}  // namespace triax::sim
