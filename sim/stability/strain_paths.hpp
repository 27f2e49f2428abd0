#pragma once
// Proportional strain paths dε₁ + 2R dε₃ = 0, Eq. (28), for many R: Fig. 16 of the paper. R = 1 is
// isochoric, R < 1 dilatant, R > 1 contractant. With dε₁ imposed, W₂ = d(σ₁′ − σ₃′/R) dε₁ (the
// second term of Eq. 30 is nil): it vanishes at the peak of σ₁′ − σ₃′/R.
#include <optional>
#include <string>
#include <vector>

#include "sim/materials/law.hpp"

namespace triax::sim {

struct StrainPathPoint {
  double axial_strain = 0;
  double control_stress = 0;  ///< σ₁′ − σ₃′/R, Pa
  double p = 0, q = 0;        ///< effective, Pa
  double void_ratio = 0;
  double normalised_work = 0;  ///< of the increment along the path, in [−1, 1]
};

struct StrainPath {
  double R = 1;
  std::vector<StrainPathPoint> points;
  std::optional<StrainPathPoint> peak;  ///< of σ₁′ − σ₃′/R, isolated; empty: none on the way
  std::optional<StrainPathPoint> first_unstable;  ///< W₂ = 0 turning negative, isolated
  std::string message;  ///< why it ended before the strain asked; empty: it did not
};

struct StrainPathOptions {
  double axial_strain = 0.05;  ///< to which dε₁ > 0 is imposed
  int rows = 200;
  double tolerance = 1e-8;  ///< of the integration, relative
};

/// Pre-condition: law.objection(start) is empty, R > 0.
StrainPath strain_path(const Law<Axisymmetric>& law, const PointState<Axisymmetric>& start,
                       double R, const StrainPathOptions& options = {});

}  // namespace triax::sim
