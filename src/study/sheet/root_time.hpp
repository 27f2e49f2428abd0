// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Consolidation over the root of time (BS 1377-8, clause 6; Taylor, 1948).
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace triax::study {

/// Where the water leaves the specimen while it consolidates.
enum class DrainageBoundary { one_end, both_ends, sides, sides_and_one_end, sides_and_both_ends };
std::string_view to_string(DrainageBoundary boundary);
std::optional<DrainageBoundary> drainage_boundary_from(std::string_view text);

/// Table 1 of BS 1377-8, for specimens twice as high as wide: c_v = π D²/(λ t_100), and the least
/// time to failure t_f = F t_100. λ and the drained F follow from theory for 95 % of dissipation
/// (Bishop and Henkel, 1962; the test does it: 80 stands for 81, F within 1 %); the undrained F
/// are Blight's (1963), one multiple of D²/c_v without and one with drains at the side.
struct BoundaryFactors {
  double lambda = 1, drained = 8.5, undrained = 0.53;
};
BoundaryFactors factors_of(DrainageBoundary boundary);

struct ConsolidationPoint {
  double time_s = 0;   ///< since the stage began
  double outflow = 0;  ///< of water, in any unit
};

/// The straight beginning V = zero + slope √t, and what Taylor's construction gives: t_100 where it
/// meets the last volume, t_90 where a line of 1/1.15 of its slope meets the curve.
struct RootTime {
  double zero = 0, slope = 0;  ///< in the unit of the outflow, over √s
  double final = 0;            ///< last outflow
  double t100_s = 0;
  std::optional<double> t90_s, t50_s;
};

/// The line is that of least squares through the first half of the outflow, without what jumped at
/// once. Nothing where fewer than five points lie in it, or none of the water came out.
std::optional<RootTime> root_time(const std::vector<ConsolidationPoint>& points);

/// m²/s. Pre-condition: t100_s > 0.
double coefficient_of_consolidation(double diameter_m, DrainageBoundary boundary, double t100_s);

}  // namespace triax::study
