// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Drives one material point along an increment under mixed control S dσ′ + E dε = dy, which is
// solved with the law's response at each instant (control_solver.hpp).
//
// Integration: an embedded Runge-Kutta pair, error-controlled; transitions onto a yield surface are
// isolated and a step never crosses a change of branch, so that the result does not depend on how a
// path is cut into increments (to the tolerance). Where the conditions cannot be met any longer the
// step stops at that state, to `smallest_step`, and names the condition.
#include <string>

#include "sim/control/control_solver.hpp"
#include "sim/point/runge_kutta.hpp"
#include "sim/point/stage_flows.hpp"

namespace triax::sim {

enum class StepOutcome {
  accepted,
  inaccurate,    ///< went to the end, but `error` exceeds the tolerance
  lost_control,  ///< condition `limiting_variable` cannot be held beyond `state`
  failed,        ///< `message` says why; `state` is the last good one
};

struct PointTolerance {
  double relative =
      1e-10;  ///< of stress to p′, of strain and void ratio to 1, per integration step
  double smallest_step = 1e-9;  ///< fraction of the increment below which a step is not halved
  int step_limit = 100000;
  /// |dε| of one increment from which on a control that gives stresses counts as lost: the strain
  /// runs away where a limit is approached and never reached.
  double runaway_strain = 1;
};

template <class Space>
struct PointStep {
  StepOutcome outcome = StepOutcome::failed;
  PointState<Space> state;  ///< at the end of what could be done
  double done = 0;          ///< fraction of the increment, 1 unless control was lost or it failed
  Vector<Space> stress_increment = Vector<Space>::Zero();  ///< of the part done, effective, Pa
  Vector<Space> strain_increment = Vector<Space>::Zero();  ///< of the part done
  double error = 0;  ///< largest estimated error of an integration step, relative
  int steps = 0;     ///< integration steps tried
  int limiting_variable = -1;
  std::string message;  ///< empty when accepted
  /// Δσ′:Δε of the part done, Pa
  double second_order_work() const { return stress_increment.dot(strain_increment); }
};

/// The driver of one law under one control, for many increments of it. Allocates nothing unless a
/// message has to be written (or a law outside this program does).
template <class Space>
class PointDriver {
 public:
  /// `reference` sets the size of the law's stiffness, for scaling; it must have no objection. Law
  /// and tolerance must outlive the driver.
  PointDriver(const Law<Space>& law, const PointState<Space>& reference,
              const MixedControl<Space>& control, const PointTolerance& tolerance);

  /// The state after the increment; the given state is never touched, so that an event is isolated
  /// by repeating the step with a part of dy. Pre-condition: law.objection(state) is empty, as it
  /// is of every state that a step ended at.
  PointStep<Space> advance(const PointState<Space>& state);

  /// Response at an instant. Pre-condition: law.objection(state) is empty.
  PointRate<Space> rate(PointState<Space> state) { return begin(state); }

 private:
  struct Trial {
    bool possible = false;      // every stage had a meaning and kept the branch
    bool lost_control = false;  // a stage could not meet the conditions
    bool refused = false;       // the law objects to where the step ends
    int limiting_variable = -1;
    PointState<Space> state;
    Vector<Space> strain;
    double error = 0;
  };

  double typical_modulus(const PointState<Space>& state);
  unsigned on_yield(const PointState<Space>& state) const;
  void settle(PointState<Space>& state);
  PointRate<Space> begin(PointState<Space>& state);
  PointRate<Space> respond(const PointState<Space>& state, const Branch& branch);
  PointRate<Space> respond(const PointState<Space>& state, const Branch& branch,
                           const PointRate<Space>& first, double fraction, int row);
  void flow_of(const PointState<Space>& at, const PointRate<Space>& rate,
               StageFlow<Space>& flow) const;
  void runge_kutta(const PointState<Space>& from, const PointRate<Space>& first, double fraction,
                   Trial& trial);
  bool keeps_branch(const PointState<Space>& at, const PointRate<Space>& rate) const;
  bool crossed(const PointState<Space>& state, unsigned active) const;
  void stop_at_crossing(const PointState<Space>& from, const PointRate<Space>& first,
                        double& fraction, Trial& trial);
  bool take_idle(const PointState<Space>& from, double fraction, Trial& trial);
  void blame(const PointState<Space>& at, const Vector<Space>& direction, PointStep<Space>& step);
  bool ran_away(const PointState<Space>& from, PointStep<Space>& step);
  bool attempt(const PointState<Space>& from, const PointRate<Space>& start, double& fraction,
               PointStep<Space>& step);
  void take(const PointRate<Space>& start, double& fraction, PointStep<Space>& step);

  const Law<Space>& law_;
  const PointTolerance& tolerance_;
  const Tableau& tableau_;
  int mechanisms_ = 0;
  unsigned standing_ = 0;  // mechanisms on whose yield surface the step began
  Response<Space> response_;
  PreparedControl<Space> control_;
  Vector<Space> guess_;  // interpolated form: dσ to start from, the one found last
  /// Interpolated form: by how much dσ of a stage differed from that of the first, per fraction.
  std::array<Vector<Space>, Tableau::kMostStages> bend_;
  StageFlows<Space> flows_;
  Trial trial_;
};

template <class Space>
PointRate<Space> point_rate(const Law<Space>& law, const PointState<Space>& state,
                            const MixedControl<Space>& control);

/// One increment: PointDriver::advance, or the driver of laws that integrate finite increments, or
/// the law itself where it is self-driven (its own tolerance holds then).
template <class Space>
PointStep<Space> advance_point(const Law<Space>& law, const PointState<Space>& state,
                               const MixedControl<Space>& control,
                               const PointTolerance& tolerance = {});

extern template class PointDriver<Axisymmetric>;
extern template class PointDriver<Tensor>;

}  // namespace triax::sim
