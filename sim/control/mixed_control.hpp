// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/mechanics/space.hpp"

namespace triax::sim {

/// As many linear conditions on the increments of effective stress and strain as the space has
/// components (two in axisymmetry, six for a tensor), on the orthonormal components of
/// sim/mechanics/space.hpp:
///
///   S dσ′ + E dε = dy
///
/// The units of a row are free as long as its entries agree; rows are scaled before they are
/// solved. Examples in axisymmetry: undrained compression, E = [[1, 0], δᵗ], S = 0, dy = (dε₁, 0);
/// constant q with falling p′, S = [[1, −1/√2], δᵗ/3], E = 0, dy = (0, dp′).
template <class Space>
struct MixedControl {
  Matrix<Space> stress = Matrix<Space>::Zero();     ///< S
  Matrix<Space> strain = Matrix<Space>::Zero();     ///< E
  Vector<Space> increment = Vector<Space>::Zero();  ///< dy

  /// All strains given.
  static MixedControl strains(const Vector<Space>& increment);
  /// All stresses given.
  static MixedControl stresses(const Vector<Space>& increment);

  // Triaxial paths; of a tensor, axes 2 and 3 are kept equal and shear strains zero.
  /// dε₁ given and dε₁ + 2R dε₃ = 0 (R = 1: undrained).
  static MixedControl strain_path(double axial_strain, double R = 1);
  /// dq and dp′ given.
  static MixedControl stress_path(double dp, double dq);
  /// dε₁ given at constant σ₃′: drained compression by displacement.
  static MixedControl drained_compression(double axial_strain);
};

/// Triaxial conditions asked of a tensor: axes 2 and 3 kept equal, in stress where no condition is
/// on strain, else in strain (row 2), and no shear strain (rows 3 to 5).
MixedControl<Tensor> as_tensor(const MixedControl<Axisymmetric>& control);

extern template struct MixedControl<Axisymmetric>;
extern template struct MixedControl<Tensor>;

}  // namespace triax::sim
