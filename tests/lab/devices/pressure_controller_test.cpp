#include "lab/devices/pressure_controller.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("a controller ramps to its target, exactly, and not beyond its limits") {
  const PressureController c{.range_pa = 1e6, .rate_limit_pa_per_s = 500};
  CHECK(process(c, 100e3, {}, 10) == 100e3);
  CHECK(process(c, 100e3, {.rate_pa_per_s = 100, .target_pa = {}}, 10) == 101e3);
  CHECK(process(c, 100e3, {.rate_pa_per_s = -100, .target_pa = {}}, 10) == 99e3);
  CHECK(process(c, 100e3, {.rate_pa_per_s = 100, .target_pa = 100.5e3}, 10) == 100.5e3);
  CHECK(process(c, 100e3, {.rate_pa_per_s = -100, .target_pa = 99.5e3}, 10) == 99.5e3);
  CHECK(process(c, 100e3, {.rate_pa_per_s = 9e3, .target_pa = {}}, 10) == 105e3);
  CHECK(process(c, 999e3, {.rate_pa_per_s = 500, .target_pa = {}}, 10) == 1e6);
  CHECK(process(c, 1e3, {.rate_pa_per_s = -500, .target_pa = {}}, 10) == 0);
  // Already beyond the target: the ramp does not turn round.
  CHECK(process(c, 100e3, {.rate_pa_per_s = 100, .target_pa = 90e3}, 10) == 100e3);
}
