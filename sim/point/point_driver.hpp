#pragma once
// Drives one material point along an increment under mixed control.
//
// At each instant the control S dσ′ + E dε = dy is solved with the law's tangent. With the elastic
// control matrix A = S C + E (all in p′, q, ε_v, ε_q):
//
//   dε = A⁻¹ (dy + S C r λ),   λ = n·C A⁻¹ dy / (h + n·C r − n·C A⁻¹ S C r)
//
// The denominator is det(S Cᵉᵖ + E)/det(A) up to a positive factor. While it is positive exactly
// one of the branches loading (λ > 0) and unloading (λ = 0) is consistent. Where it vanishes under
// loading the programme cannot be held: loss of control in Nova's sense.
//
// Integration: Dormand-Prince 5(4), error-controlled; transitions elastic -> plastic are isolated,
// so that the result does not depend on how a path is cut into increments (to the tolerance).
#include <string>

#include "sim/materials/sanisand.hpp"
#include "sim/mechanics/axisymmetric.hpp"
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

/// The rate of a point under a control, per unit of dy.
struct PointRate {
  bool controllable = false;  ///< false: the conditions cannot be met, nothing below has meaning
  bool plastic = false;
  double multiplier = 0;  ///< λ
  int culprit = -1;  ///< row of the control that cannot be held; −1: the rows are not independent
  Eigen::Vector2d stress = Eigen::Vector2d::Zero();          ///< (dp′, dq), Pa
  Eigen::Vector2d strain = Eigen::Vector2d::Zero();          ///< (dε_v, dε_q)
  Eigen::Vector2d plastic_strain = Eigen::Vector2d::Zero();  ///< (dε_v^p, dε_q^p)
  /// dσ′:dε = dp′ dε_v + dq dε_q
  double second_order_work() const { return stress.dot(strain); }
};

template <class Law>
struct PointStep {
  StepOutcome outcome = StepOutcome::failed;
  typename Law::State state;  ///< at the end of what could be done
  double done = 0;            ///< fraction of the increment, 1 unless control was lost or it failed
  AxisymmetricStress stress_increment;  ///< of the part done, effective, Pa
  AxisymmetricStrain strain_increment;  ///< of the part done
  double error = 0;  ///< largest estimated error of an integration step, relative
  int culprit = -1;
  std::string message;  ///< empty when accepted
  /// Δσ′:Δε of the part done, Pa
  double second_order_work() const {
    return stress_increment.axial * strain_increment.axial +
           2 * stress_increment.radial * strain_increment.radial;
  }
};

/// Response at an instant. Pre-condition: law.objection(state) is empty.
template <class Law>
PointRate point_rate(const Law& law, const typename Law::State& state, const MixedControl& control);

/// The state after the increment; the caller's state is never touched, so that an event is isolated
/// by repeating the step with a part of dy. Allocates nothing unless a message has to be written.
template <class Law>
PointStep<Law> advance_point(const Law& law, const typename Law::State& state,
                             const MixedControl& control, const PointTolerance& tolerance = {});

extern template PointRate point_rate(const Sanisand&, const Sanisand::State&, const MixedControl&);
extern template PointStep<Sanisand> advance_point(const Sanisand&, const Sanisand::State&,
                                                  const MixedControl&, const PointTolerance&);

}  // namespace triax::sim
