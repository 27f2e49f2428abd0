// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// c′ and φ′ of a set of specimens with their Mohr circles (ISO 17892-9; ASTM D7181 and D4767).
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/study/soil/line_fit.hpp"
#include "src/study/soil/test_points.hpp"

namespace triax::study {

/// The instant at which a specimen counts as failed.
enum class FailureCriterion {
  peak_deviator_stress,
  peak_stress_ratio,
  axial_strain,
  critical_state
};
std::string_view to_string(FailureCriterion criterion);
/// Of "peak-q", "peak-ratio", "strain", "critical-state". Throws lab::BadInput.
FailureCriterion failure_criterion(const std::string& word);

struct MohrCircle {
  std::size_t test = 0;  ///< among those asked
  std::string name;
  double major_kPa = 0, minor_kPa = 0;  ///< σ₁′, σ₃′
};

/// σ₁′ = A + K σ₃′ through the circles, which is their common tangent:
///
///   sin φ′ = (K − 1)/(K + 1),   c′ = A/(2 √K).
///
/// Specimens scatter by a share of their strength rather than by so many kPa: each has the weight
/// 1/σ₁′², and a scatter beyond 2 % of it is added to all alike (line_fit.hpp).
struct StrengthSet {
  FailureCriterion criterion = FailureCriterion::peak_deviator_stress;
  std::vector<MohrCircle> circles;
  LineFit line;
  Estimate cohesion_kPa;
  Estimate friction_angle_deg;
  /// With c′ = 0, where the interval of c′ holds 0.
  std::optional<Estimate> friction_angle_without_cohesion_deg;
};

/// The state of failure; empty where the test did not come to it. `strain`: that of axial_strain.
std::optional<TestPoint> failure_of(const TestPoints& test, FailureCriterion criterion,
                                    double strain);
/// The circle of a state: σ₁′ = p′ + 2q/3, σ₃′ = p′ − q/3; in extension σ₁′ is radial.
MohrCircle circle_of(const TestPoint& failure, bool extension);

/// Nothing for fewer than three circles, or where σ₃′ does not differ.
std::optional<StrengthSet> strength_set(std::vector<MohrCircle> circles,
                                        FailureCriterion criterion);
/// Of a circle as a point of that fit.
FitPoint strength_point(const MohrCircle& circle);

}  // namespace triax::study
