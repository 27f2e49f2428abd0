#pragma once
#include <Eigen/Core>

namespace triax::sim {

/// Incremental response of a law with one plastic mechanism at one state, in work-conjugate
/// invariants σ = (p′, q), ε = (ε_v, ε_q), Pa:
///
///   dσ = C (dε − λ r),   λ ≥ 0,   n·dσ ≤ h λ,   λ (n·dσ − h λ) = 0
///
/// r and h may carry a common positive factor (λ is then measured in it), which is how a law says
/// "infinitely stiff just after a reversal" (r = 0, h > 0) without an infinite number.
struct ElastoplasticTangent {
  Eigen::Matrix2d elastic = Eigen::Matrix2d::Zero();  ///< C, Pa
  Eigen::Vector2d flow = Eigen::Vector2d::Zero();     ///< r
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();   ///< n
  double hardening = 0;                               ///< h, Pa
};

}  // namespace triax::sim
