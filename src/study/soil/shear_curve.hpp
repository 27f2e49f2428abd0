// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The shear of a test as means over steps of the axial strain.
#include <optional>
#include <vector>

#include "lab/results/state.hpp"

namespace triax::study {

/// Means of the states within one step. Stresses in kPa; of a test in extension q, the strains ε_a
/// and ε_q are turned round, so that all of them grow; p′ and ε_v are as they are.
struct CurvePoint {
  double axial_strain = 0, shear_strain = 0, volumetric_strain = 0;
  double q_kPa = 0, p_eff_kPa = 0;
  std::optional<double> void_ratio;
  double eta() const { return q_kPa / p_eff_kPa; }
};

struct ShearCurve {
  bool extension = false;
  std::vector<CurvePoint> points;  ///< with rising axial strain
};

/// Steps grow with the strain, so that a peak at 0.3 % is seen as well as a rest at 20 %: the i-th
/// of 150 ends at (i/150)² of the largest strain. Where the axis turns back (an unloading, the
/// cycles of a load), states are left out until the strain is as large again. A closed valve: ε_v
/// is 0 where the record does not tell it.
ShearCurve shear_curve(const std::vector<lab::State>& states, bool drained,
                       std::optional<double> void_ratio);

/// y = at + slope (x − x0) by least squares.
struct LocalFit {
  double at = 0, slope = 0;
  double at_error = 0, slope_error = 0;  ///< standard, from the residuals
};
/// Nothing for fewer than three points or where x stands still.
std::optional<LocalFit> local_fit(const std::vector<double>& x, const std::vector<double>& y,
                                  double x0);

}  // namespace triax::study
