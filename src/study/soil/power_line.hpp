// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The critical state line as a power of p′ (Li and Wang, 1998).
#include <optional>
#include <vector>

#include "src/study/soil/line_fit.hpp"

namespace triax::study {

inline constexpr double kPowerPressure_kPa = 100;  ///< p_r
inline constexpr double kUsualExponent = 0.7;      ///< held where the tests do not determine it

/// e = e₀ − λ (p′/p_r)^ξ. For each ξ of a grid from 0.05 to 1.5 it is a line over (p′/p_r)^ξ; with
/// S(ξ) its weighted sum of squares and S* the least, the interval of ξ is where
///
///   S(ξ) ≤ S* (1 + t²/(n − 3)),   t of Student with n − 3 degrees,
///
/// and those of e₀ and λ are the farthest that lie on some line within that sum: profiles, which
/// hold how the three depend on each other.
struct PowerLine {
  Estimate void_ratio;  ///< e₀
  Estimate slope;       ///< λ
  Estimate exponent;    ///< ξ
  bool exponent_held = false;
  LineFit line;  ///< over (p′/p_r)^ξ with the best ξ
  double at(double p_eff_kPa) const;
};

/// Points are x = ln(p′/1 kPa), y = e. An exponent that is given, or that the points leave open at
/// an end of the grid, is held. Nothing for fewer than three points.
std::optional<PowerLine> fit_power_line(const std::vector<FitPoint>& points,
                                        std::optional<double> exponent);

}  // namespace triax::study
