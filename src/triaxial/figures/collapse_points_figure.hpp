#pragma once
#include <optional>

#include "src/plot/drawing.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

/// Slope of the line through the origin that fits the collapse points best, η = Σ q p′ / Σ p′²;
/// nothing without points.
std::optional<double> fitted_instability_line(const std::vector<study::TestResult>& tests);

/// Stress ratios of the limit surfaces of the tests that collapsed, rising; those that print alike
/// are one.
std::vector<double> limits_of(const std::vector<study::TestResult>& tests);

/// The collapse points of all tests in the q-p′ plane, with one instability line fitted through
/// them and the Mohr-Coulomb line of each limit that was used. A marker shape per type of test;
/// filled for recorded tests, open for simulated ones. No plot without a collapse point.
Drawing collapse_points_figure(const std::vector<study::TestResult>& tests);

}  // namespace triax::src
