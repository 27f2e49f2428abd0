#pragma once
#include <Eigen/Core>

namespace triax::sim {

/// Two linear conditions on an axisymmetric increment:
///
///   S (dσ₁′, dσ₃′)ᵗ + E (dε₁, dε₃)ᵗ = dy
///
/// The units of a row are free as long as its entries agree; rows are scaled before they are
/// solved. Examples: undrained compression E = [[1, 0], [1, 2]], S = 0, dy = (dε₁, 0); constant q
/// with falling p′: S = [[1, −1], [1/3, 2/3]], E = 0, dy = (0, dp′).
struct MixedControl {
  Eigen::Matrix2d stress = Eigen::Matrix2d::Zero();     ///< S
  Eigen::Matrix2d strain = Eigen::Matrix2d::Zero();     ///< E
  Eigen::Vector2d increment = Eigen::Vector2d::Zero();  ///< dy

  /// dε₁ given and dε₁ + 2R dε₃ = 0 (R = 1: undrained).
  static MixedControl strain_path(double axial_strain, double R = 1);
  /// dq and dp′ given.
  static MixedControl stress_path(double dp, double dq);
  /// dε₁ given at constant σ₃′: drained compression by displacement.
  static MixedControl drained_compression(double axial_strain);
};

}  // namespace triax::sim
