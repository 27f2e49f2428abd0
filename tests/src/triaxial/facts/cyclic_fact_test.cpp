// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/facts/cyclic_fact.hpp"

#include <catch2/catch.hpp>

using namespace triax;

TEST_CASE("cycles, and when they liquefied the specimen or what they came to at most") {
  lab::CyclicLoading cyclic{.cycles = 7.5,
                            .q_low_pa = -20.04e3,
                            .q_high_pa = 24.6e3,
                            .stress_ratio = 0.1488,
                            .largest_pore_pressure_ratio = 0.97,
                            .largest_double_amplitude = 0.0312,
                            .liquefied = {},
                            .double_amplitude = {}};
  cyclic.liquefied.emplace().instant.reading = 712;
  cyclic.liquefied->cycle = 6;
  const auto lines = src::cyclic_lines(cyclic);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0] ==
        "7.5 cycles of q from -20.0 to 24.6 kPa, CSR = (q_max − q_min)/(4 p′₀) = 0.149");
  CHECK(lines[1] == "r_u = Δu/σ₃′₀ of 0.95 in cycle 6, at reading 712");
  CHECK(lines[2] == "double amplitude of 5 % not reached, maximum 3.12 %");
}
