// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/zero_stress.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

const StageInfo kFrame{.number = 1,
                       .name = "shear",
                       .role = StageRole::shear,
                       .drainage = Drainage::closed,
                       .control = AxialControl::displacement};

/// q rises to 100 kPa at reading 50; then q and p' fall in proportion and are zero at reading 90.
State liquefied(int reading) {
  const double left = reading <= 50 ? 1 : std::max(0.0, (90.0 - reading) / 40);
  State s;
  s.reading = reading;
  s.time_s = reading;
  s.strain.axial = reading * 1e-3;
  s.q = std::min(reading / 50.0, 1.0) * 100e3 * left;
  s.p_eff = 200e3 * left;
  return s;
}

std::optional<Finding> search(const StageInfo& stage, int readings, State (*state)(int)) {
  ZeroStress zero;
  zero.start_stage(&stage);
  for (int i = 0; i < readings; ++i) zero.add_state(state(i), true, Moment{i, double(i)});
  return zero.finding();
}

}  // namespace

TEST_CASE("ZeroStress: p' and q that vanish under displacement are found", "[collapse]") {
  const auto found = search(kFrame, 120, liquefied);
  REQUIRE(found);
  CHECK(found->instant.reading == 90);
  CHECK(found->instant.q_pa == 0.0);
  REQUIRE(found->noticed);
  CHECK(found->noticed->reading == 92);  // the third reading confirms
  REQUIRE(found->instant.interval);
  CHECK(found->instant.interval->p_eff_pa.holds(5e3));  // the reading before
  CHECK_FALSE(found->instant.interval->p_eff_pa.holds(11e3));
  CHECK(found->evidence.find("100.00 kPa") != std::string::npos);
}

TEST_CASE("ZeroStress: two readings are not enough", "[collapse]") {
  CHECK_FALSE(search(kFrame, 92, liquefied));
  CHECK(search(kFrame, 93, liquefied));
}

TEST_CASE("ZeroStress: p' alone is enough, and so is q alone", "[collapse]") {
  const auto only_p = search(kFrame, 120, [](int i) {
    State s = liquefied(i);
    s.q = 50e3;
    return s;
  });
  REQUIRE(only_p);
  CHECK(only_p->instant.reading == 90);
  const auto only_q = search(kFrame, 120, [](int i) {
    State s = liquefied(i);
    s.p_eff = 150e3;
    return s;
  });
  REQUIRE(only_q);
  CHECK(only_q->instant.reading == 90);
}

TEST_CASE("ZeroStress: an unloading is not a loss of control", "[collapse]") {
  CHECK_FALSE(search(kFrame, 120, [](int i) {
    State s = liquefied(i);
    if (i > 50) s.strain.axial = 0.05 - (i - 50) * 1e-4;
    return s;
  }));
}

TEST_CASE("ZeroStress: q near zero at the start of shear is none", "[collapse]") {
  CHECK_FALSE(search(kFrame, 120, [](int i) {
    State s = liquefied(i);
    s.q = i % 2 == 0 ? 100.0 : 0.0;
    s.p_eff = 200e3;
    return s;
  }));
}

TEST_CASE("ZeroStress: extension is searched as compression is", "[collapse]") {
  const auto found = search(kFrame, 120, [](int i) {
    State s = liquefied(i);
    s.q = -s.q;
    s.strain.axial = -s.strain.axial;
    return s;
  });
  REQUIRE(found);
  CHECK(found->instant.reading == 90);
}

TEST_CASE("ZeroStress: under load another criterion searches", "[collapse]") {
  StageInfo load = kFrame;
  load.control = AxialControl::load;
  CHECK_FALSE(search(load, 120, liquefied));
  load.control = AxialControl::constant_q;
  CHECK_FALSE(search(load, 120, liquefied));
  load.control = AxialControl::unknown;
  CHECK(search(load, 120, liquefied));
}

TEST_CASE("ZeroStress: a new stage keeps the finding of the one before", "[collapse]") {
  ZeroStress zero;
  zero.start_stage(&kFrame);
  for (int i = 0; i < 100; ++i) zero.add_state(liquefied(i), true, std::nullopt);
  zero.start_stage(&kFrame);
  for (int i = 0; i < 120; ++i) zero.add_state(liquefied(i), true, std::nullopt);
  REQUIRE(zero.finding());
  CHECK(zero.finding()->instant.reading == 90);
  CHECK_FALSE(zero.finding()->noticed);
}
