// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Total uncertainty of an onset: its repeatability and the errors that all readings have in common.
#include <optional>

#include "lab/results/summary.hpp"

namespace triax::lab {

/// What instruments and dimensions may be wrong by, each the half width of a rectangular
/// distribution (JCGM 100, 4.3.7: u = a/√3). Assumed: a load cell of class 1 (ISO 7500-1, 1 % of
/// the force), pressure transducers that differ by 0.5 kPa and 0.1 % of the pressure from the true
/// one after zeroing, a diameter measured to 0.1 mm.
struct CommonErrors {
  double force = 0.01;             ///< of the reading
  double pressure_pa = 500;        ///< of each transducer
  double pressure = 0.001;         ///< of its reading
  double diameter_m = 1e-4;        ///< of the measured diameter
  double usual_diameter_m = 0.05;  ///< where the record does not give one
};

/// First order in the errors (JCGM 100, 5.1.2), with σ₃ = p′ − q/3 + u and A ∝ D²:
///   δq = q (δF/F − 2 δD/D),  δp′ = δq/3 + δσ₃ − δu,  δη = (δq − η δp′)/p′
/// for independent δF/F, δD/D, δσ₃, δu. Each end of the interval of repeatability is widened by
/// 1.96 u, independent of it:
///   v_low = v − √((v − v_repeatability)² + (1.96 u)²).
/// The budget has the fraction of each source in the variance of η, largest first; half the width
/// of the interval of repeatability over 1.96 is the standard uncertainty of that one. q and p′ in
/// Pa; p′ > 0. Empty without an interval, q, p′ or at p′ ≤ 0.
std::optional<TotalUncertainty> total_uncertainty(const Instant& onset,
                                                  const std::optional<double>& diameter_m,
                                                  const CommonErrors& errors = {});

}  // namespace triax::lab
