// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Grain sizes of a specimen.
#include <cstdint>
#include <vector>

namespace triax::sim {

/// Cumulative grading by count: `share` of all grains have at most `diameter_m`, linear in between.
/// The first share may be above 0: so many grains have the smallest diameter itself.
struct GradingCurve {
  std::vector<double> diameter_m;  ///< > 0, ascending, at least one
  std::vector<double> share;       ///< 0 to 1, ascending, the last is 1

  friend bool operator==(const GradingCurve&, const GradingCurve&) = default;
};

/// 2 to 9.5 mm with D₅₀ = 5 mm: the range of the paper's section 5; the shares between are those
/// of public re-creations of its specimen.
GradingCurve paper_grading();

/// Throws std::invalid_argument that names the first thing wrong.
void check(const GradingCurve& curve);

/// Diameter that `share` of the grains do not exceed, m. Pre-condition: share 0 to 1, checked
/// curve.
double diameter_at(const GradingCurve& curve, double share);
/// Share of the curve at a diameter.
double share_at(const GradingCurve& curve, double diameter_m);

/// `count` diameters in random order: one drawn from each of `count` equal parts of the curve, so
/// that their own curve differs from it nowhere by more than 1/count. The same seed gives the same
/// diameters. Throws std::invalid_argument as check().
std::vector<double> draw_diameters(const GradingCurve& curve, int count, std::uint64_t seed);

}  // namespace triax::sim
