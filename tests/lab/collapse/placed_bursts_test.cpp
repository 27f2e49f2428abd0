// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/placed_bursts.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "lab/measured/path_sampler.hpp"

using namespace triax::lab;

namespace {

const StageInfo kLoadStage{.number = 1,
                           .name = {},
                           .role = StageRole::shear,
                           .drainage = Drainage::closed,
                           .control = AxialControl::load};

/// Under a load that grows by 1 kPa a reading: η from 0 to 0.6, then strain runs away and q goes.
State at(int reading, int fall) {
  const double x = std::min(reading, fall) / 60.0;
  State s;
  s.reading = reading;
  s.time_s = reading;
  s.q = reading < fall ? 1e3 * reading : 5e3;
  s.p_eff = reading < fall ? 1e5 - 2e4 * x * x : 1e4;
  s.pore_pressure = 4e5 - s.p_eff + s.q / 3;
  s.volumetric_strain = 0;
  const double axial = reading < fall ? 0.002 * x / (1.05 - x) : 0.2;
  s.strain = {axial, -axial / 2};
  s.area_m2 = 0.004;
  s.effective_stress = {s.p_eff + 2 * s.q / 3, s.p_eff - s.q / 3};
  return s;
}

struct Watched {
  LossOfControl control;
  PathHistory history;
  explicit Watched(int fall, int readings) {
    control.start_stage(&kLoadStage);
    PathSampler sampler(true);
    for (int i = 0; i < readings; ++i) {
      const State s = at(i, fall);
      control.add_state(s, true);
      if (const auto sample = sampler.sample(s)) history.add(*sample);
    }
  }
};

}  // namespace

TEST_CASE("a sudden fall is placed between the readings around it") {
  const Watched watched(50, 54);
  REQUIRE(watched.control.found());
  REQUIRE(watched.control.sudden());
  PlacedBursts bursts;
  bursts.place(watched.control, watched.history, {}, {.q = 0});
  const PlacedBurst* one = bursts.of(*watched.control.found());
  REQUIRE(one);
  CHECK(one->of == watched.control.found()->instant.reading);
  REQUIRE(one->fall);
  CHECK(one->fall->reading == 49);
  REQUIRE(one->fall->interval);
  CHECK(one->fall->interval->q_pa.holds(49.5e3));
  CHECK_FALSE(one->work);  // nothing says how its readings scatter
}

TEST_CASE("a burst that was not placed is none") {
  const Watched watched(50, 54), other(40, 44);
  PlacedBursts bursts;
  bursts.place(watched.control, watched.history, {}, {.q = 0});
  CHECK_FALSE(bursts.of(*other.control.found()));
  // Another one takes the place of one that was not kept as the earlier.
  bursts.place(other.control, other.history, {}, {.q = 0});
  CHECK(bursts.of(*other.control.found()));
  CHECK_FALSE(bursts.of(*watched.control.found()));
}
