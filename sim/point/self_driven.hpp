// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/point/point_driver.hpp"

namespace triax::sim {

/// How closely a self-driven law can meet conditions: what is asked finer is asked in vain.
struct DrivingTolerance {
  double stress_pa = 0;  ///< > 0
  double strain = 0;     ///< > 0
  /// Times that a condition may be missed by more where the law does not run smoothly; whoever asks
  /// for totals makes up for it in the next increment. ≥ 1
  double loosened = 1;
};

/// A law that meets mixed control by itself, as a specimen inside a specimen does: it is not
/// integrated, it is moved. advance_point and point_rate hand over to it.
template <class Space>
class SelfDriven {
 public:
  virtual ~SelfDriven() = default;

  /// The state after the increment; the given one is never touched, and the same call gives the
  /// same bits. Conditions without stress hold to round-off, the others to the tolerance. Outcomes
  /// as of PointDriver::advance. Pre-condition: law.objection(state) is empty.
  virtual PointStep<Space> drive(const PointState<Space>& state,
                                 const MixedControl<Space>& control) const = 0;

  /// What the next small increment is thought to do: cheap, of the accuracy of a prediction, and
  /// not controllable where it is in doubt.
  virtual PointRate<Space> rate(const PointState<Space>& state,
                                const MixedControl<Space>& control) const = 0;

  /// Whether a small increment of this control can be met; tried where the prediction is in doubt.
  virtual bool sustains(const PointState<Space>& state,
                        const MixedControl<Space>& control) const = 0;

  virtual DrivingTolerance tolerance(const PointState<Space>& state) const = 0;
};

}  // namespace triax::sim
