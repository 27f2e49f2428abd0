// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Values around the circle of directions, ready to be drawn.
#include <functional>
#include <vector>

#include "sim/stability/cones.hpp"

namespace triax::src {

struct AngleValue {
  double angle = 0;  ///< rad, rising; beyond 2π where a run passes α = 0
  double value = 0;
};

/// Neighbouring directions whose values have one sign; 0 belongs to both.
struct SignedRun {
  bool negative = false;
  std::vector<AngleValue> points;
};

using ProbeValue = std::function<double(const sim::Probe&)>;

/// The values of the answered probes once around from the first, straight between neighbours at
/// steps of at most `step` (rad), cut where the sign changes and at directions without an answer.
/// What rounds to an edge of a cone (|value| < 1e-9) is 0.
std::vector<SignedRun> signed_runs(const std::vector<sim::Probe>& probes, const ProbeValue& value,
                                   double step);

}  // namespace triax::src
