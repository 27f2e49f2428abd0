// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Controllability of a state under the control pair (dε₁ + 2R dε₃, dσ₁′ − dσ₃′/R) (axisymmetry) or
// (dε₁ + R dε₃, dσ₁′ − dσ₃′/R) (plane strain), and under any mixed control (Nova).
//
// With dε₁ + 2R dε₃ = 0 held, W₂ = d(σ₁′ − σ₃′/R) dε₁ (Eq. 30, 31). What the control of R leaves
// free where its determinant vanishes is a stress increment dσ₁ = dσ₃/R with dε₁ + 2R dε₃ = 0, so
// that W₂ = 0: control is lost at an R whose direction is the edge of a cone. In which sense of
// σ₁′ − σ₃′/R depends on the path the specimen fails: where the mode shortens it, dε₁ > 0, the
// stress cannot grow (compression); where it lengthens it, the stress cannot fall (extension). For
// a zone these R are the roots of Eqs. (34), (35) (proportional_control.hpp); for an incrementally
// nonlinear law they are those of the tangent compliance of that direction.
#include <optional>
#include <string>
#include <vector>

#include "sim/stability/proportional_control.hpp"

namespace triax::sim {

/// Sense in which σ₁′ − σ₃′/R is driven.
enum class ControlSense { loading, unloading };

enum class ControlState {
  held,
  lost,
  unanswered,  ///< the law refuses what the control asks or fails at it: nothing is known
};

/// One control in one sense.
struct ControlAnswer {
  ControlState state = ControlState::unanswered;
  /// Nova's index: the determinant of the control matrix (Eq. 32, 33) of the answer over that of
  /// the law's elastic or linear part (PointRate::determinant). 1 far from loss of control, towards
  /// 0 at it; empty where control is lost, as then there is no answer whose determinant it were.
  std::optional<double> index;
  Probe probe;  ///< the increment under that control; answered only where control is held
  int limiting_variable =
      -1;  ///< where lost: the row of the control that cannot be held; −1: not known

  bool held() const { return state == ControlState::held; }
};

/// The control matrix of Eq. (32), (33) with the tangent compliance of a mode's direction.
struct ControlMatrix {
  Eigen::Matrix2d entries = Eigen::Matrix2d::Zero();
  double determinant = 0;
  double failure_rule = 0;  ///< dε₁/dσ₃ of the mode by Eq. (40), (41), 1/Pa
};

/// One R of a scan: with dε₁ + 2R dε₃ = 0 (plane strain: dε₁ + R dε₃ = 0) held, is a small change
/// of σ₁′ − σ₃′/R possible, in either sense?
struct ControlPoint {
  double R = 1;
  bool controllable = false;    ///< held in both senses
  std::optional<double> index;  ///< the lesser of both senses; empty unless controllable
  ControlAnswer loading, unloading;
  /// The direction that the control leaves free at index 0, dσ₁ = dσ₃/R, of the two senses the one
  /// with less normalised W₂: the failure mode, whose strains obey Eq. (40), (41) there.
  Probe mode;
  std::optional<ControlMatrix> matrix;  ///< of the mode; empty where it has no tangent
};

/// The control of one R with d(σ₁′ − σ₃′/R) = 1 Pa, or −1 Pa. Pre-condition: R ≠ 0.
template <class Space>
MixedControl<Space> proportional_control(double R, ControlSense sense = ControlSense::loading);

/// Pre-condition: no R is 0.
template <class Space>
std::vector<ControlPoint> scan_control(const IncrementalResponse<Space>& response,
                                       const std::vector<double>& R);

/// A range of R in which control is lost in one sense.
struct LostControl {
  double from = 0, to = 0;  ///< as far as the range that was searched and answered
  /// The limits are those of control, not ends of the range that was searched or answered.
  bool begins = false, ends = false;
  ControlSense sense = ControlSense::loading;
};

struct ControlSearch {
  std::vector<LostControl> lost;  ///< those of loading, then those of unloading, each by rising R
  int asked = 0, unanswered = 0;  ///< steps of R, of both senses
};

/// Both senses, searched in equal steps of R, the limits isolated to 1e-12 of the range: a loss
/// within one step is not seen. What the law does not answer is neither held nor lost.
/// Pre-condition: 0 < R_from < R_to.
template <class Space>
ControlSearch lost_control(const IncrementalResponse<Space>& response, double R_from, double R_to,
                           int steps = 200);

/// What a control is called, and what it asks of a triaxial specimen.
struct NamedControl {
  std::string name;  ///< "undrained, dq > 0"
  MixedControl<Axisymmetric> control;
  std::vector<std::string> conditions = {};  ///< what its rows are called; may be empty
};
/// Undrained by load and by displacement, q constant by stress and by volume, drained compression
/// by load and by displacement, all strains.
std::vector<NamedControl> triaxial_controls();

struct ControlIndex {
  std::string name;
  ControlAnswer answer;
  std::string limiting_variable =
      {};  ///< where lost: the condition that cannot be held, if it has a name
};
std::vector<ControlIndex> control_indices(const IncrementalResponse<Axisymmetric>& response,
                                          const std::vector<NamedControl>& controls);

}  // namespace triax::sim
