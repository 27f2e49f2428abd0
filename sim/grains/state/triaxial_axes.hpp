// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A box of grains as a triaxial specimen: axis 1 of the paper is the third of the box (upright in a
// picture), its axes 2 and 3 are the other two. Compression positive, SI, strains natural.
#include <array>
#include <cmath>

#include "sim/grains/state/grain_state.hpp"
#include "sim/grains/state/walls.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::sim {

inline constexpr int kAxial = 2;
inline constexpr std::array<int, 2> kRadial{0, 1};

/// σ₁ and the mean of both radial stresses on the walls, Pa.
inline AxisymmetricStress axisymmetric_stress(const GrainState& s) {
  return {wall_stress(s.walls, s.box, kAxial),
          0.5 * (wall_stress(s.walls, s.box, 0) + wall_stress(s.walls, s.box, 1))};
}

/// ln(L₀/L) of each axis.
inline std::array<double, 3> natural_strain(const GrainBox& from, const GrainBox& to) {
  std::array<double, 3> strain{};
  for (int a = 0; a < 3; ++a) {
    const double shortening = from.length_m(a) - to.length_m(a);
    strain[a] = -std::log1p(-shortening / from.length_m(a));
  }
  return strain;
}

/// The same; radial is the mean of both axes.
inline AxisymmetricStrain axisymmetric_strain(const GrainBox& from, const GrainBox& to) {
  const auto strain = natural_strain(from, to);
  return {strain[kAxial], 0.5 * (strain[0] + strain[1])};
}

/// σ₁ − σ₃/R, conjugate to ε₁ where dε₁ + 2R dε₃ = 0. Pre-condition: ratio R > 0.
constexpr double path_stress(const AxisymmetricStress& s, double ratio) {
  return s.axial - s.radial / ratio;
}

inline std::array<AxisDrive, 3> triaxial_drives(const AxisDrive& axial, const AxisDrive& radial) {
  return {radial, radial, axial};
}
/// The strain path dε₁ + 2R dε₃ = 0 of Eq. (28), led by axis 1. Pre-condition: ratio R > 0.
inline std::array<AxisDrive, 3> strain_path_drives(const AxisDrive& axial, double ratio) {
  return triaxial_drives(axial, following_drive(kAxial, -0.5 / ratio));
}

}  // namespace triax::sim
