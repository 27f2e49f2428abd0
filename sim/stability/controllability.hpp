#pragma once
// Controllability of a state under the control pair (dε₁ + 2R dε₃, dσ₁′ − dσ₃′/R) (axisymmetry) or
// (dε₁ + R dε₃, dσ₁′ − dσ₃′/R) (plane strain), and under any mixed control (Nova).
//
// What the control of R leaves free where its determinant vanishes is a stress increment
// dσ₁ = dσ₃/R with dε₁ + 2R dε₃ = 0, so that W₂ = 0 (Eq. 30, 31): control is lost exactly at the R
// whose direction is the edge of a cone, whatever the law. For a zone these are the roots of
// Eqs. (34), (35) (proportional_control.hpp); for an incrementally nonlinear law they are those of
// the tangent compliance of that direction.
#include <string>
#include <vector>

#include "sim/stability/probe.hpp"

namespace triax::sim {

/// One R of a scan: with dε₁ + 2R dε₃ = 0 (plane strain: dε₁ + R dε₃ = 0) held, is a small
/// d(σ₁′ − σ₃′/R) > 0 possible?
struct ControlPoint {
  double R = 1;
  bool controllable = false;
  /// Nova's index: the determinant of the control matrix (Eq. 32, 33) of the answer over that of
  /// the law's elastic or linear part (PointRate::determinant). 1 far from loss of control, 0 or
  /// less where it is lost.
  double index = 0;
  Probe answer;  ///< the increment under that control; not answered where control is lost
  /// The direction that the control leaves free at index 0, dσ₁ = dσ₃/R, of the two senses the one
  /// with less normalised W₂: the failure mode, whose strains obey Eq. (40), (41) there.
  Probe mode;
};

/// The control of one R with d(σ₁′ − σ₃′/R) = 1 Pa. Pre-condition: R ≠ 0.
template <class Space>
MixedControl<Space> proportional_control(double R);

/// Pre-condition: no R is 0.
template <class Space>
std::vector<ControlPoint> scan_control(const IncrementalResponse<Space>& response,
                                       const std::vector<double>& R);

/// A range of R in which control is lost.
struct LostControl {
  double from = 0, to = 0;  ///< as far as the range that was searched
  /// The limits are those of the law within the range, not its ends.
  bool begins = false, ends = false;
};

/// Searched in equal steps of R, the limits isolated to 1e-12 of the range: a loss within one step
/// is not seen. Pre-condition: 0 < R_from < R_to.
template <class Space>
std::vector<LostControl> lost_control(const IncrementalResponse<Space>& response, double R_from,
                                      double R_to, int steps = 200);

/// What a control is called, and what it asks of a triaxial specimen.
struct NamedControl {
  std::string name;  ///< "undrained, dq > 0"
  MixedControl<Axisymmetric> control;
};
/// Undrained by load and by displacement, q constant by stress and by volume, drained compression
/// by load and by displacement, all strains.
std::vector<NamedControl> triaxial_controls();

struct ControlIndex {
  std::string name;
  bool controllable = false;
  double index = 0;  ///< PointRate::determinant; 0 or less where control is lost
  Probe answer;      ///< not answered where control is lost
};
std::vector<ControlIndex> control_indices(const IncrementalResponse<Axisymmetric>& response,
                                          const std::vector<NamedControl>& controls);

}  // namespace triax::sim
