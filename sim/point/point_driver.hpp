#pragma once
// Drives one material point along an increment under mixed control S dσ′ + E dε = dy, which is
// solved with the law's response at each instant (control_solver.hpp).
//
// Integration: an embedded Runge-Kutta pair, error-controlled; transitions onto a yield surface are
// isolated and a step never crosses a change of branch, so that the result does not depend on how a
// path is cut into increments (to the tolerance). Where the conditions cannot be met any longer the
// step stops at that state, to `smallest_step`, and names the condition.
#include <string>

#include "sim/materials/law.hpp"
#include "sim/point/mixed_control.hpp"

namespace triax::sim {

enum class StepOutcome {
  accepted,
  inaccurate,    ///< went to the end, but `error` exceeds the tolerance
  lost_control,  ///< condition `culprit` cannot be held beyond `state`
  failed,        ///< `message` says why; `state` is the last good one
};

struct PointTolerance {
  double relative = 1e-10;      ///< of stress to p′, of void ratio to 1, per integration step
  double smallest_step = 1e-9;  ///< fraction of the increment below which a step is not halved
  int step_limit = 100000;
};

template <class Space>
struct PointStep {
  StepOutcome outcome = StepOutcome::failed;
  PointState<Space> state;  ///< at the end of what could be done
  double done = 0;          ///< fraction of the increment, 1 unless control was lost or it failed
  Vector<Space> stress_increment = Vector<Space>::Zero();  ///< of the part done, effective, Pa
  Vector<Space> strain_increment = Vector<Space>::Zero();  ///< of the part done
  double error = 0;  ///< largest estimated error of an integration step, relative
  int steps = 0;     ///< integration steps taken
  int culprit = -1;
  std::string message;  ///< empty when accepted
  /// Δσ′:Δε of the part done, Pa
  double second_order_work() const { return stress_increment.dot(strain_increment); }
};

/// Response at an instant. Pre-condition: law.objection(state) is empty.
template <class Space>
PointRate<Space> point_rate(const Law<Space>& law, const PointState<Space>& state,
                            const MixedControl<Space>& control);

/// The state after the increment; the caller's state is never touched, so that an event is isolated
/// by repeating the step with a part of dy. Allocates nothing unless a message has to be written
/// (or a law outside this program does).
template <class Space>
PointStep<Space> advance_point(const Law<Space>& law, const PointState<Space>& state,
                               const MixedControl<Space>& control,
                               const PointTolerance& tolerance = {});

}  // namespace triax::sim
