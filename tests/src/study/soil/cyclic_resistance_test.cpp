// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "src/study/soil/soil.hpp"
#include "src/study/soil/soil_fits.hpp"

using namespace triax;

namespace {

constexpr double kA = 0.3, kB = 0.25;

/// Tests that liquefy in these cycles, on CSR = a N^−b but for these factors; the double amplitude
/// comes after twice as many.
study::Soil cyclic_soil(const std::vector<int>& cycles, const std::vector<double>& factors) {
  study::Soil soil;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    study::TestPoints test;
    test.name = "C" + std::to_string(i + 1);
    lab::CyclicLoading loading;
    loading.stress_ratio = kA * std::pow(cycles[i], -kB) * factors[i];
    loading.liquefied = lab::CycleInstant{};
    loading.liquefied->cycle = cycles[i];
    loading.double_amplitude = lab::CycleInstant{};
    loading.double_amplitude->cycle = 2 * cycles[i];
    test.cyclic = loading;
    soil.tests.push_back(test);
  }
  return soil;
}

}  // namespace

TEST_CASE("Tests on CSR = a N^-b give back a and b") {
  auto soil = cyclic_soil({3, 8, 20, 50, 120}, {1, 1, 1, 1, 1});
  study::fit_cyclic(soil, {});
  REQUIRE(soil.cyclic.size() == 2);
  const auto& curve = soil.cyclic.front();
  CHECK(curve.criterion == "pore_pressure_ratio");
  CHECK(std::exp(curve.trend.line.a) == Approx(kA).epsilon(1e-6));
  CHECK(-curve.trend.line.b == Approx(kB).epsilon(1e-6));
  CHECK(curve.at_cycles(15) == Approx(kA * std::pow(15, -kB)).epsilon(1e-6));
  CHECK(curve.trend.tests.size() == 5);
  CHECK(soil.cyclic.back().criterion == "double_amplitude");
  CHECK(soil.cyclic.back().at_cycles(40) == Approx(kA * std::pow(20, -kB)).epsilon(1e-6));
  CHECK(soil.notes.empty());
}

// ln CSR off the line by d, -2d, 0, 2d, -d at ln N = 4, 5, 6, 7, 8 changes its mean by nothing and
// its slope by (-2 + 2 + 2 - 2) d/10 = 0: the products with -2, -1, 0, 1, 2 are -2, 2, 0, 2, -2.
// Half a cycle is less than 1 % there, and b times that has no part in it.
TEST_CASE("Intervals of a and b are those of Student's t about the line") {
  constexpr double kD = 0.03;
  const std::vector<int> cycles = {55, 148, 403, 1097, 2981};  // e^4 to e^8
  std::vector<double> factors;
  for (const double off : {1.0, -2.0, 0.0, 2.0, -1.0}) factors.push_back(std::exp(off * kD));
  auto soil = cyclic_soil(cycles, factors);
  study::fit_cyclic(soil, {});
  REQUIRE(!soil.cyclic.empty());
  const auto slope = soil.cyclic.front().trend.line.slope();
  const double s2 = 10 * kD * kD / 3, half = 3.18245 * std::sqrt(s2 / 10);  // t of 3 degrees
  CHECK(slope.value == Approx(-kB).margin(2e-3));
  CHECK((slope.high - slope.low) / 2 == Approx(half).epsilon(0.02));
  CHECK(slope.holds(-kB));
  const auto at_e6 = soil.cyclic.front().trend.line.line_at(6);
  CHECK((at_e6.high - at_e6.low) / 2 == Approx(3.18245 * std::sqrt(s2 / 5)).epsilon(0.02));
}

TEST_CASE("A cyclic test that lies off the others is named") {
  auto soil = cyclic_soil({3, 8, 20, 50, 120, 250, 400}, {1, 1.02, 0.98, 2.0, 1, 1.01, 0.99});
  study::fit_cyclic(soil, {});
  REQUIRE(!soil.cyclic.empty());
  CHECK(soil.tests[3].reason.find("ln CSR is 0.69") == 0);
  CHECK(-soil.cyclic.front().trend.line.b == Approx(kB).margin(0.02));
}

TEST_CASE("Two cyclic tests make no curve, and it is said") {
  auto soil = cyclic_soil({3, 30}, {1, 1});
  study::fit_cyclic(soil, {});
  CHECK(soil.cyclic.empty());
  CHECK(!soil.notes.empty());
}
