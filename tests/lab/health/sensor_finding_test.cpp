// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/sensor_finding.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("a finding says sensor, fault, value in units of the field, readings and time") {
  SensorFinding f{Quantity::axial_force, SensorFault::stuck, 230, 460.0, {}, 123.4};
  CHECK(describe(f) ==
        "the load cell (axial_force) is stuck at 0.1234 kN from reading 230 (460 s) on");
  f.until = 300;
  CHECK(describe(f) ==
        "the load cell (axial_force) is stuck at 0.1234 kN from reading 230 (460 s) to 300");
  f.from_time_s.reset();
  f.fault = SensorFault::spike;
  f.until = 230;
  CHECK(describe(f) == "the load cell (axial_force) gave a spike of 0.1234 kN at reading 230");
  CHECK(reason(f) == "the load cell (axial_force) gave a spike");
}

TEST_CASE("what is missing has no value, and columns without a sensor have a name") {
  const SensorFinding f{Quantity::pore_pressure, SensorFault::missing, 7, {}, {}, 0};
  CHECK(describe(f) ==
        "the pore-pressure transducer (pore_pressure) gives no readings from reading 7 on");
  CHECK(sensor_name(Quantity::deviator_stress) == "the column (deviator_stress)");
  CHECK(to_string(SensorFault::saturated) == "saturated");
}
