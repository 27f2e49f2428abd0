// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/served/served_devices.hpp"

#include <catch2/catch.hpp>

#include "lab/programmes/programme_reader.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;
using Catch::Contains;

namespace {

struct Rig {
  double now_s = 0;
  ServedPlant plant{read_programme(test::programme_text(), "p.toml"), 3};
  ServedDrives drives{plant, 2, [this] { return now_s; }};
  WireDevice frame = drives.frame(), cell = drives.cell_controller(),
             back = drives.back_controller();

  static double value(const WireDevice& device, const char* point) {
    return device.find(point)->read();
  }
  static void set(const WireDevice& device, const char* point, double value) {
    device.find(point)->write(value);
  }
  void pass(double seconds) {
    for (double t = 0; t < seconds - 1e-9; t += 0.25) plant.tick(0.25);
  }
};

}  // namespace

TEST_CASE("set points take effect when the mode is set, and not before") {
  Rig rig;
  Rig::set(rig.cell, "rate_kPa_per_min", 60);
  Rig::set(rig.cell, "target_kPa", 405);
  rig.pass(2);
  CHECK(Rig::value(rig.cell, "set_point_kPa") == Approx(400));
  Rig::set(rig.cell, "mode", 2);
  rig.pass(2);
  CHECK(Rig::value(rig.cell, "set_point_kPa") == Approx(402));
  rig.pass(10);
  CHECK(Rig::value(rig.cell, "set_point_kPa") == 405);
  CHECK(Rig::value(rig.cell, "pressure_kPa") == Approx(405));
}

TEST_CASE("a crosshead moves the cap at the velocity that was ordered") {
  Rig rig;
  Rig::set(rig.back, "valve_open", 0);
  Rig::set(rig.frame, "velocity_mm_per_min", 1.2);
  Rig::set(rig.frame, "mode", 1);
  rig.pass(10);
  CHECK(Rig::value(rig.frame, "displacement_mm") == Approx(0.2).epsilon(1e-6));
  CHECK(Rig::value(rig.frame, "force_N") > 10);
  CHECK(Rig::value(rig.back, "volume_mm3") == Approx(0).margin(1e-6));
}

TEST_CASE("what is beyond the limits of a device is refused, and the set point stays") {
  Rig rig;
  CHECK_THROWS_WITH(Rig::set(rig.frame, "velocity_mm_per_min", 7), Contains("-5.99999 to 5.99999"));
  CHECK_THROWS_AS(Rig::set(rig.cell, "target_kPa", -1), Refused);
  CHECK_THROWS_AS(Rig::set(rig.cell, "target_kPa", 1e9), Refused);
  CHECK_THROWS_AS(Rig::set(rig.cell, "mode", 4), Refused);
  CHECK_THROWS_AS(Rig::set(rig.cell, "mode", 1.5), Refused);
  CHECK_THROWS_AS(Rig::set(rig.back, "valve_open", 2), Refused);
  CHECK(Rig::value(rig.frame, "velocity_mm_per_min") == 0);
  CHECK(rig.cell.find("valve_open") == nullptr);
}

TEST_CASE("a device whose controller falls silent stops or holds, and the next order wakes it") {
  Rig rig;
  Rig::set(rig.frame, "velocity_mm_per_min", 1);
  Rig::set(rig.frame, "mode", 1);
  Rig::set(rig.cell, "rate_kPa_per_min", 60);
  Rig::set(rig.cell, "mode", 1);
  rig.frame.heard();
  rig.cell.heard();
  rig.now_s = 1.9;
  rig.drives.watch();
  CHECK(Rig::value(rig.frame, "state") == 0);
  rig.cell.heard();
  rig.now_s = 2.1;
  rig.drives.watch();
  CHECK(Rig::value(rig.frame, "state") == 4);
  CHECK(Rig::value(rig.frame, "mode") == 0);
  CHECK(Rig::value(rig.cell, "watchdog") == 0);
  rig.now_s = 4;
  rig.drives.watch();
  CHECK(Rig::value(rig.cell, "watchdog") == 1);
  const double held = Rig::value(rig.cell, "set_point_kPa");
  rig.pass(5);
  CHECK(Rig::value(rig.cell, "set_point_kPa") == held);
  CHECK(Rig::value(rig.frame, "displacement_mm") == Approx(0).margin(1e-9));
  rig.frame.heard();
  Rig::set(rig.frame, "mode", 1);
  CHECK(Rig::value(rig.frame, "state") == 0);
}

TEST_CASE("a watchdog listens to the client that ordered last, not to whoever asks") {
  Rig rig;
  const int driver = rig.drives.new_client(), watcher = rig.drives.new_client();
  const auto bites = [&](int who) {
    rig.drives.speaks(driver);
    rig.frame.heard();
    Rig::set(rig.frame, "velocity_mm_per_min", 0.1);
    Rig::set(rig.frame, "mode", 1);
    for (int i = 0; i < 5; ++i) {
      rig.now_s += 1;
      rig.drives.speaks(who);
      rig.frame.heard();
      rig.drives.watch();
    }
    return Rig::value(rig.frame, "state") == static_cast<double>(FrameState::watchdog);
  };
  CHECK_FALSE(bites(driver));
  CHECK(bites(watcher));
  CHECK_FALSE(bites(driver));
}

TEST_CASE("a frame at the end of its travel says so and stands") {
  Programme programme = read_programme(test::programme_text(), "p.toml");
  programme.frame.travel_m = 1e-4;
  ServedPlant plant(programme, 1);
  plant.open_valve(false);
  plant.order_axis({.mode = FrameMode::crosshead, .velocity_m_per_s = 1e-4});
  for (int i = 0; i < 8; ++i) plant.tick(0.25);
  CHECK(plant.frame_state() == FrameState::end_of_travel);
  CHECK_THAT(plant.stands_because(), Contains("travel limit"));
  CHECK(plant.time_s() == 2);
}

TEST_CASE("a fault is switched on and off while the plant runs") {
  Rig rig;
  rig.pass(1);
  const double before = Rig::value(rig.cell, "pressure_kPa");
  rig.plant.add_fault({.device = "cell_pressure", .kind = FaultKind::drift, .size = 1e3});
  rig.pass(2);
  CHECK(Rig::value(rig.cell, "pressure_kPa") == Approx(before + 2).margin(1e-6));
  rig.plant.clear_faults();
  rig.pass(1);
  CHECK(Rig::value(rig.cell, "pressure_kPa") == Approx(before).margin(1e-6));
}
