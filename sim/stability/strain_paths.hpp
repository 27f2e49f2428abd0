// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Proportional strain paths dε₁ + 2R dε₃ = 0, Eq. (28), for many R: Fig. 16 of the paper. R = 1 is
// isochoric, R < 1 dilatant, R > 1 contractant. With dε₁ imposed, W₂ = d(σ₁′ − σ₃′/R) dε₁ (the
// second term of Eq. 30 is nil): it vanishes at the peak of σ₁′ − σ₃′/R.
#include <optional>
#include <string>
#include <vector>

#include "sim/law/law.hpp"

namespace triax::sim {

struct StrainPathPoint {
  double axial_strain = 0;
  double control_stress = 0;  ///< σ₁′ − σ₃′/R, Pa
  double p = 0, q = 0;        ///< effective, Pa
  double void_ratio = 0;
  /// Of the increment along the path, in [−1, 1]; empty where the path cannot go on.
  std::optional<double> normalised_work;

  double eta() const { return q / p; }
};

struct StrainPath {
  double R = 1;
  std::vector<StrainPathPoint> points;  ///< the start, the rows and where it ended
  std::optional<StrainPathPoint> peak;  ///< first one of σ₁′ − σ₃′/R, isolated; empty: none
  /// Where W₂ first turns negative, isolated; the start where it is so there already.
  std::optional<StrainPathPoint> first_unstable;
  /// Where p′ first falls below least_p: neither of the two is looked for from there on.
  std::optional<StrainPathPoint> vanished;
  std::string message;  ///< why it ended before the strain asked; empty: it did not
};

struct StrainPathOptions {
  double axial_strain = 0.05;  ///< to which dε₁ > 0 is imposed
  int rows = 200;
  double tolerance = 1e-8;  ///< of the integration, relative
  /// p′ (Pa) below which the stress counts as vanished. A dilatant path of sand ends at p′ = 0 in a
  /// last small hump of σ₁′ − σ₃′/R, which laws that keep a liquefied state alive there make
  /// (SANISAND and its moduli fade their contraction below 0.02 p_at); it is no peak of the soil.
  double least_p = 2e3;
};

/// Events are isolated to 1e-10 of a part, one of at least 500 equal ones: a peak that comes and
/// goes within a part is not seen. Whatever the material does is in the result. Pre-condition:
/// law.objection(start) is empty, R > 0, axial_strain > 0, rows > 0; throws std::invalid_argument
/// where these numbers are not.
StrainPath strain_path(const Law<Axisymmetric>& law, const PointState<Axisymmetric>& start,
                       double R, const StrainPathOptions& options = {});

}  // namespace triax::sim
