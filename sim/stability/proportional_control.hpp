// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Control of a proportional strain path, the pair (dσ₁′ − dσ₃′/R, dε₁ + 2R dε₃) of axisymmetry
// (Eq. 28) or (dσ₁′ − dσ₃′/R, dε₁ + R dε₃) of plane strain (Eq. 29). With c = √2 or 1 and
//
//   (dε₁, c dε₃) = M (dσ₁, c dσ₃)       M = Q of Eq. (38) or P of Eq. (39)
//
// the matrix of Eqs. (32), (33) on (dε₁, dσ₃/R) has the determinant
//
//   (c² M₂₂ R² + c (M₁₂ + M₂₁) R + M₁₁)/M₁₁ = vᵗ M v/M₁₁,   v = (1, cR)
//
// the second-order work of the stress direction dσ₁ = dσ₃/R. Its zeros are Eqs. (34), (35) divided
// by E₁E₃: the quadratic has real roots where det Mˢ < 0, and then W₂ < 0 between them. So
// everything here serves the tangent compliance of any law; the forms in moduli are those of the
// paper's zones.
//
// Read against its equations, the paper has these slips: "Eqs. (35) and (36)", whose double root
// the first unstable direction is, are (34) and (35); Eq. (36) is the reduced discriminant
// (b/2)² − ac, Eq. (37) the full one; and in Eq. (41) the factor 1 − V₁²V₂¹ before 1/R is missing,
// which the first row of Eq. (33) has.
#include <vector>

#include "sim/stability/probe.hpp"
#include "sim/stability/zone_moduli.hpp"

namespace triax::sim {

/// M of the plane, 1/Pa.
struct PlaneCompliance {
  ProbePlane plane = ProbePlane::axisymmetric;
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();

  /// c
  double weight() const { return plane == ProbePlane::axisymmetric ? std::numbers::sqrt2 : 1; }
  /// Determinant of the symmetric part, 1/Pa².
  double symmetric_determinant() const;
  /// W₂ per |dσ|² in the direction α of probe.hpp, 1/Pa.
  double work(double angle) const;
};

PlaneCompliance plane_compliance(const AxisymmetricModuli& moduli);
PlaneCompliance plane_compliance(const PrincipalModuli& moduli);  ///< plane strain
PlaneCompliance plane_compliance(const Matrix<Axisymmetric>& compliance);
/// In plane strain: dε₂ and shear strains are kept at zero. Empty where no stress can do that.
std::optional<PlaneCompliance> plane_compliance(const Matrix<Tensor>& compliance);
/// Of the tangent at a rate; empty where there is none.
template <class Space>
std::optional<PlaneCompliance> plane_compliance(const IncrementalResponse<Space>& response,
                                                const PointRate<Space>& rate) {
  const auto compliance = response.tangent_compliance(rate);
  if (!compliance) return std::nullopt;
  return plane_compliance(*compliance);
}

/// a R² + b R + c.
struct Quadratic {
  double a = 0, b = 0, c = 0;

  double operator()(double R) const { return (a * R + b) * R + c; }
  double discriminant() const { return b * b - 4 * a * c; }           ///< Eq. (37)
  double reduced_discriminant() const { return discriminant() / 4; }  ///< Eq. (36)
  /// Real roots, ascending; none, one (double, or a = 0) or two.
  std::vector<double> roots() const;
  /// −b/(2a), the double root R* where the discriminant vanishes.
  double double_root() const { return -b / (2 * a); }
};

/// Eqs. (34), (35) divided by E₁E₃.
Quadratic control_quadratic(const PlaneCompliance& compliance);
Quadratic control_quadratic(const AxisymmetricModuli& moduli);  ///< Eq. (34)
Quadratic control_quadratic(const PrincipalModuli& moduli);     ///< Eq. (35)

/// (dσ₁ − dσ₃/R, dε₁ + 2R dε₃ or dε₁ + R dε₃) from (dε₁, dσ₃/R). Pre-conditions: R ≠ 0, M₁₁ ≠ 0.
Eigen::Matrix2d control_matrix(const PlaneCompliance& compliance, double R);
Eigen::Matrix2d control_matrix(const AxisymmetricModuli& moduli, double R);  ///< Eq. (32)
Eigen::Matrix2d control_matrix(const PrincipalModuli& moduli, double R);     ///< Eq. (33)
/// Its determinant; exact also where M₁₁ or R makes the matrix ill-conditioned.
double control_determinant(const PlaneCompliance& compliance, double R);

/// Failure rule: dε₁/dσ₃ (1/Pa) of the mode that a singular control matrix leaves free.
double failure_rule(const PlaneCompliance& compliance, double R);
double failure_rule(const AxisymmetricModuli& moduli, double R);  ///< Eq. (40)
double failure_rule(const PrincipalModuli& moduli, double R);     ///< Eq. (41), its slip mended

/// Direction of the mode's stress, dσ₁ = dσ₃/R with dσ₁ > 0: α in (0, π). The one that unloads is
/// π beyond; only that in the zone of the compliance has a meaning.
double failure_angle(ProbePlane plane, double R);

}  // namespace triax::sim
