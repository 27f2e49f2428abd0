// SPDX-License-Identifier: GPL-3.0-or-later
// What is sent to a device makes it demand of the plant what the software demanded, to the bit.
#include "lab/wire/remote/drive_settings.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <string>

#include "lab/programmes/programme_reader.hpp"
#include "lab/wire/served/served_devices.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;

namespace {

void send(const WireDevice& device, const DriveSettings& settings) {
  for (const PointSetting& one : settings)
    if (one.point != "mode") device.find(one.point)->write(one.value);
  for (const PointSetting& one : settings)
    if (one.point == "mode") device.find(one.point)->write(one.value);
}

std::string text(const DriveSettings& settings) {
  std::string all;
  for (const PointSetting& one : settings) all += fmt::format("{} {:.9g}; ", one.point, one.value);
  return all;
}

struct Frame {
  ServedPlant plant{read_programme(test::programme_text(), "p.toml"), 1};
  ServedDrives drives{plant, 0, [] { return 0.0; }};
  WireDevice frame = drives.frame();

  AxisDemand through(const AxisDemand& demand) {
    send(frame, frame_settings(demand, 0.25));
    AxisOrders orders;
    orders.order(plant.axis(), 0);
    return orders.demand(0, 0.25);
  }
};

void check_equal(const AxisDemand& a, const AxisDemand& b) {
  CHECK(a.kind == b.kind);
  CHECK(a.velocity_m_per_s == b.velocity_m_per_s);
  CHECK(a.spring_n_per_m == b.spring_n_per_m);
  CHECK(a.start_force_n == b.start_force_n);
  CHECK(a.force_n == b.force_n);
  CHECK(a.area_m2 == b.area_m2);
  CHECK(a.start_stress_pa == b.start_stress_pa);
  CHECK(a.stress_pa == b.stress_pa);
  CHECK(a.dead == b.dead);
  CHECK(a.perturbed == b.perturbed);
  CHECK(a.impulse_n_s == b.impulse_n_s);
}

}  // namespace

TEST_CASE("every way to drive the axis comes through") {
  using Kind = AxisDemand::Kind;
  Frame frame;
  const AxisDemand all[] = {
      {.kind = Kind::free},
      {.kind = Kind::crosshead, .velocity_m_per_s = 0.05e-3 / 60},
      {.kind = Kind::crosshead, .velocity_m_per_s = -1.0 / 3e5, .spring_n_per_m = 12345.6},
      {.kind = Kind::force, .start_force_n = 101.1, .force_n = 1000.0 / 7},
      {.kind = Kind::force,
       .start_force_n = 5,
       .force_n = 6,
       .perturbed = true,
       .impulse_n_s = 0.3},
      {.kind = Kind::force, .start_force_n = 77.7, .force_n = 77.7, .dead = true},
      {.kind = Kind::force,
       .start_force_n = 1.5,
       .force_n = 1.5,
       .area_m2 = 3.8484510006474963e-3,
       .start_stress_pa = 61234.5,
       .stress_pa = 61235.25},
  };
  for (const AxisDemand& demand : all) check_equal(frame.through(demand), demand);
  check_equal(frame.through({.kind = Kind::crosshead}), {.kind = Kind::crosshead});
}

TEST_CASE("pressures, flow and valve come through") {
  CHECK(text(pressure_settings({})) == "mode 0; ");
  CHECK(text(pressure_settings({.rate_pa_per_s = 500, .target_pa = 4e5})) ==
        "rate_kPa_per_min 30; target_kPa 400; mode 2; ");
  CHECK(text(pressure_settings({.rate_pa_per_s = -500, .target_pa = {}})) ==
        "rate_kPa_per_min -30; mode 1; ");
  PlantDemand demand;
  demand.valve_open = false;
  CHECK(text(back_settings(demand)) == "mode 0; valve_open 0; ");
  demand.outflow_m3_per_s = 2e-9;
  CHECK(text(back_settings(demand)) == "flow_mm3_per_s 2; mode 3; valve_open 0; ");
}
