// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/fault.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace triax::lab;

TEST_CASE("a fault is active from its begin to before its end") {
  const Fault fault{
      .device = "valve", .kind = FaultKind::does_not_close, .from_s = 10, .until_s = 20};
  CHECK_FALSE(fault.active(9.999));
  CHECK(fault.active(10));
  CHECK(fault.active(19.999));
  CHECK_FALSE(fault.active(20));
  CHECK(Fault{.device = "valve", .from_s = 10}.active(1e9));
}

TEST_CASE("a fault is described in words with the unit of the field") {
  Fault fault{.device = "pore_pressure", .kind = FaultKind::stuck, .from_s = 3600};
  CHECK(describe(fault) == "simulated fault: pore_pressure stuck from 3600 s");
  fault.kind = FaultKind::spike;
  fault.size = 20e3;
  fault.until_s = 4000;
  CHECK(describe(fault) == "simulated fault: pore_pressure spike of ±20 kPa from 3600 s to 4000 s");
  fault.kind = FaultKind::drift;
  fault.size = -50;
  CHECK(describe(fault) ==
        "simulated fault: pore_pressure drift of -3 kPa/min from 3600 s to 4000 s");
  CHECK(describe({.device = "axial_force", .kind = FaultKind::spike, .size = 12}) ==
        "simulated fault: axial_force spike of ±12 N from 0 s");
  CHECK(describe({.device = "axial_force", .kind = FaultKind::latency, .size = 2.5}) ==
        "simulated fault: axial_force latency of 2.5 s from 0 s");
  CHECK(describe({.device = "back_controller", .kind = FaultKind::leak, .size = 1e-15}) ==
        "simulated fault: back_controller leak of 6 mm3/min at 100 kPa from 0 s");
  CHECK(describe({.device = "valve", .kind = FaultKind::does_not_close}) ==
        "simulated fault: valve does not close from 0 s");
}

TEST_CASE("every device has faults, each with a name of its own, and strangers have none") {
  CHECK(fault_devices().size() == 11);
  for (const auto& device : fault_devices()) CHECK_FALSE(possible_faults(device).empty());
  CHECK(possible_faults("axial_strain").empty());
  CHECK(possible_faults("boiler").empty());
  std::vector<std::string> names;
  for (int i = 0; i <= static_cast<int>(FaultKind::does_not_open); ++i)
    names.emplace_back(to_string(static_cast<FaultKind>(i)));
  CHECK(names.size() == 11);
  std::ranges::sort(names);
  CHECK(std::ranges::adjacent_find(names) == names.end());
}

TEST_CASE("the active faults of a device are found, in their order") {
  const std::vector<Fault> all{
      {.device = "valve", .kind = FaultKind::does_not_open, .from_s = 5},
      {.device = "pore_pressure", .kind = FaultKind::spike, .from_s = 0, .until_s = 9, .size = 1},
      {.device = "pore_pressure", .kind = FaultKind::stuck, .from_s = 8}};
  CHECK(active_faults(all, "valve", 4).empty());
  CHECK(active_faults(all, "pore_pressure", 8) == std::vector<Fault>{all[1], all[2]});
  CHECK(active_faults(all, "pore_pressure", 9) == std::vector<Fault>{all[2]});
  CHECK(holds(all, FaultKind::stuck));
  CHECK_FALSE(holds(all, FaultKind::leak));
}
