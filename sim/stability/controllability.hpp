#pragma once
// Controllability of a state under the control pair (dε₁ + 2R dε₃, dσ₁′ − dσ₃′/R) (axisymmetry) or
// (dε₁ + R dε₃, dσ₁′ − dσ₃′/R) (plane strain), and under any mixed control (Nova).
#include <optional>
#include <vector>

#include "sim/stability/probe.hpp"

namespace triax::sim {

/// One R of a scan: with dε₁ + 2R dε₃ = 0 (plane strain: dε₁ + R dε₃ = 0) held, is a small
/// d(σ₁′ − σ₃′/R) > 0 possible?
struct ControlPoint {
  double R = 1;
  bool controllable = false;
  /// Determinant of the control matrix (Eq. 32, 33) in the zone of the answer over that of the
  /// law's elastic or linear part: Nova's index, 1 far from loss of control, ≤ 0 beyond it.
  double index = 0;
  Probe mode;  ///< the increment under that control; at index 0 the failure mode (Eq. 40, 41)
};

std::vector<ControlPoint> scan_control(const IncrementalResponse<Axisymmetric>& response,
                                       const std::vector<double>& R);
std::vector<ControlPoint> scan_control(const IncrementalResponse<Tensor>& response,
                                       const std::vector<double>& R);

}  // namespace triax::sim
