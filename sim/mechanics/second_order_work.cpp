// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mechanics/second_order_work.hpp"

#include <algorithm>
#include <cmath>

namespace triax::sim {

SecondOrderWork second_order_work(const StretchedState& at,
                                  const AxisymmetricStress& stress_increment,
                                  const AxisymmetricStrain& strain_increment) {
  const AxisymmetricStress& ds = stress_increment;
  const AxisymmetricStrain& de = strain_increment;
  SecondOrderWork w;
  w.small_strain = ds.axial * de.axial + 2 * ds.radial * de.radial;

  const double stretch_1 = 1 - at.strain.axial, volume = 1 - volumetric_strain(at.strain);
  const double stretch_3 = std::sqrt(volume / stretch_1);
  const double rate_1 = de.axial / stretch_1;  // logarithmic increments, −L dt
  const double dilation = volumetric_strain(de) / volume;
  const double rate_3 = (dilation - rate_1) / 2;
  const auto& s = at.effective_stress;
  w.eulerian = (ds.axial - dilation * s.axial + rate_1 * s.axial) * rate_1 +
               2 * (ds.radial - dilation * s.radial + rate_3 * s.radial) * rate_3;

  // Π₁ = σ₁λ₃², Π₃ = σ₃λ₁λ₃ and dF = −dλ, so that dΠ:dF changes sign twice.
  const double shortened_3 = stretch_3 * rate_3;
  const double nominal_1 = ds.axial * stretch_3 * stretch_3 - 2 * s.axial * stretch_3 * shortened_3;
  const double nominal_3 = ds.radial * stretch_1 * stretch_3 -
                           s.radial * (stretch_3 * de.axial + stretch_1 * shortened_3);
  w.semi_lagrangian = nominal_1 * de.axial + 2 * nominal_3 * shortened_3;

  const double stress_norm = std::sqrt(ds.axial * ds.axial + 2 * ds.radial * ds.radial);
  const double strain_norm = std::sqrt(de.axial * de.axial + 2 * de.radial * de.radial);
  const double norms = stress_norm * strain_norm;
  w.normalised = norms > 0 ? std::clamp(w.small_strain / norms, -1.0, 1.0) : 0.0;
  return w;
}

}  // namespace triax::sim
