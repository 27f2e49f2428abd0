// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Moduli of generalised triaxial paths, on which one principal stress changes alone,
//
//   E_j = dσ_j/dε_j,   V_j^i = −dε_i/dε_j
//
// and the compliances Q (Eq. 38) and P (Eq. 39) of a tensorial zone: a combination of the signs of
// dσ₁, dσ₂, dσ₃, in which column j of the compliance is that of N⁺ for dσ_j > 0, of N⁻ for dσ_j < 0
// (sim/law/response.hpp). The moduli of the paper's Eqs. (32) to (41) are those of zone
// (−, −, −). Moduli in Pa, compliances in 1/Pa.
#include <array>

#include "sim/law/response.hpp"

namespace triax::sim {

/// N of principal stresses and strains: dε = N dσ.
using PrincipalCompliance = Eigen::Matrix3d;

/// Which columns are those of loading. Of axisymmetry the last two are the same.
struct ZoneSigns {
  std::array<bool, 3> loading{};
};

/// Of a stress increment, by its components along the axes; what stands still counts as falling.
ZoneSigns zone_of(const Vector<Axisymmetric>& stress);
ZoneSigns zone_of(const Vector<Tensor>& stress);

PrincipalCompliance zone_compliance(const InterpolatedForm<Tensor>& form, const ZoneSigns& zone);
/// Q, on (dσ₁, √2 dσ₃).
Matrix<Axisymmetric> zone_compliance(const InterpolatedForm<Axisymmetric>& form,
                                     const ZoneSigns& zone);

/// E_j and V_j^i of all three axes.
struct PrincipalModuli {
  Eigen::Vector3d e_pa;  ///< E_j
  Eigen::Matrix3d v;     ///< (i, j): V_j^i; −1 on the diagonal
};

/// Those of axisymmetry. V₃³ = −dε₂/dε₃ where σ₃ changes alone; named v13 for V₁³ and so on.
struct AxisymmetricModuli {
  double e1_pa = 0, e3_pa = 0;
  double v13 = 0, v31 = 0, v33 = 0;
};

/// Pre-condition: no E_j is infinite (N_jj ≠ 0), here and below.
PrincipalModuli principal_moduli(const PrincipalCompliance& n);
PrincipalCompliance principal_compliance(const PrincipalModuli& moduli);

/// Pre-condition: axes 2 and 3 answer alike.
AxisymmetricModuli axisymmetric_moduli(const PrincipalCompliance& n);
/// From Q alone, which holds E₃ and V₃³ only as E₃/(1 − V₃³) and V₃¹ only as V₃¹/(1 − V₃³): the
/// moduli with V₃³ = 0 that have this Q. E₃ itself needs a path on which σ₂ and σ₃ differ.
AxisymmetricModuli axisymmetric_moduli(const Matrix<Axisymmetric>& q);

/// Q of Eq. (38): (dε₁, √2 dε₃) = Q (dσ₁, √2 dσ₃).
Matrix<Axisymmetric> axisymmetric_compliance(const AxisymmetricModuli& moduli);
/// P of Eq. (39): (dε₁, dε₃) = P (dσ₁, dσ₃) with dε₂ = 0.
Eigen::Matrix2d plane_strain_compliance(const PrincipalModuli& moduli);

}  // namespace triax::sim
