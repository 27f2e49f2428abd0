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
  std::string message;  ///< why it ended before the strain asked; empty: it did not
};

struct StrainPathOptions {
  double axial_strain = 0.05;  ///< to which dε₁ > 0 is imposed
  int rows = 200;
  double tolerance = 1e-8;  ///< of the integration, relative
};

/// Events are isolated to 1e-10 of a part, one of at least 500 equal ones: a peak that comes and
/// goes within a part is not seen. Whatever the material does is in the result. Pre-condition:
/// law.objection(start) is empty, R > 0, axial_strain > 0, rows > 0; throws std::invalid_argument
/// where these numbers are not.
StrainPath strain_path(const Law<Axisymmetric>& law, const PointState<Axisymmetric>& start,
                       double R, const StrainPathOptions& options = {});

}  // namespace triax::sim
