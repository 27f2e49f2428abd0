// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Decides whether the ramp of a pressure controller has reached its target, from what the
// controller says of its set point.
#include <cmath>

#include "lab/programmes/end_condition.hpp"
#include "lab/results/reading.hpp"

namespace triax::lab {

class RampTarget {
 public:
  /// A look at the set point. `predicted_pa` is where the software expected it, Pa.
  void look(double predicted_pa, double said_pa) {
    before_pa_ = said_pa_;
    said_pa_ = said_pa;
    predicted_pa_ = predicted_pa;
  }
  /// True if the set point meets the condition and this look does not stand alone: the look before
  /// meets it, too, or the set point is no farther from the predicted one than `step_pa`, the way
  /// of the ramp in one tick. So no single wrong reply ends a stage.
  bool met(const EndCondition& end, double step_pa) const {
    if (!end.met(said_pa_)) return false;
    return std::fabs(said_pa_ - predicted_pa_) <= step_pa || end.met(before_pa_);
  }

 private:
  double said_pa_ = kMissing, before_pa_ = kMissing, predicted_pa_ = kMissing;
};

}  // namespace triax::lab
