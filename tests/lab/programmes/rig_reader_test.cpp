// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/rig_reader.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/programmes/rig_text.hpp"

using namespace triax::lab;
using Catch::Contains;
using test::complaint_of_rig;
using test::with_rig;

TEST_CASE("a rig of which nothing is said is ideal, with a piston of 5 kg") {
  const Programme p = with_rig("");
  for (const PressureController* c : {&p.cell_controller, &p.back_controller}) {
    CHECK(c->range_pa == 3e6);
    CHECK(c->rate_limit_pa_per_s == Approx(10e3));
    CHECK(c->pressure_resolution_pa == 0);
    CHECK(c->time_constant_s == 0);
    CHECK(c->fluid_compliance_m3_per_pa == 0);
    CHECK(c->capacity_m3 == 0);
    CHECK_FALSE(c->start_volume_m3);
    CHECK(c->volume_rate_limit_m3_per_s == 0);
    CHECK(c->leak_m3_per_s_per_pa == 0);
  }
  CHECK(p.frame.velocity_step_m_per_s == 0);
  CHECK(p.frame.stiffness_n_per_m == 0);
  CHECK(p.frame.load_limit_n == 0);
  CHECK(p.frame.bandwidth_hz == 0);
  CHECK(p.frame.moving_mass_kg == 5);
  CHECK(p.frame.damping_n_s_per_m == 50);
  CHECK(p.faults.empty());
}

TEST_CASE("controllers and frame are read in SI") {
  const Programme p = with_rig(R"(drainage_resistance_kPa_s_per_mm3 = 0.5
[rig.back_controller]
range_kPa = 2000
rate_limit_kPa_per_min = 120
pressure_resolution_kPa = 1
time_constant_s = 2
fluid_compliance_mm3_per_kPa = 3
capacity_cm3 = 200
start_volume_cm3 = 80
volume_rate_limit_mm3_per_s = 500
leak_mm3_per_min_at_100kPa = 6
[rig.frame]
velocity_step_mm_per_min = 0.6
stiffness_kN_per_mm = 20
load_limit_N = 5000
bandwidth_Hz = 2
moving_mass_kg = 7
damping_N_s_per_m = 30
)");
  const PressureController& c = p.back_controller;
  CHECK(c.range_pa == 2e6);
  CHECK(c.rate_limit_pa_per_s == Approx(2e3));
  CHECK(c.pressure_resolution_pa == 1e3);
  CHECK(c.time_constant_s == 2);
  CHECK(c.fluid_compliance_m3_per_pa == Approx(3e-12));
  CHECK(c.capacity_m3 == Approx(200e-6));
  CHECK(c.start_volume_m3.value_or(0) == Approx(80e-6));
  CHECK(c.volume_rate_limit_m3_per_s == Approx(500e-9));
  // 0.1 mm3/s at 100 kPa
  CHECK(c.leak_m3_per_s_per_pa * 100e3 == Approx(0.1e-9));
  CHECK(p.frame.velocity_step_m_per_s == Approx(1e-5));
  CHECK(p.frame.stiffness_n_per_m == Approx(20e6));
  CHECK(p.frame.load_limit_n == 5000);
  CHECK(p.frame.bandwidth_hz == 2);
  CHECK(p.frame.moving_mass_kg == 7);
  CHECK(p.frame.damping_n_s_per_m == 30);
}

TEST_CASE("a set of instruments is a base that explicit keys override") {
  const Programme p = with_rig(R"(instruments = "standard"
drainage_resistance_kPa_s_per_mm3 = 0.5
[rig.transducers.pore_pressure]
noise_kPa = 0.5
[rig.back_controller]
time_constant_s = 9
)");
  const Transducer& u = p.transducers[index(Quantity::pore_pressure)];
  CHECK(u.noise_rms == 0.5);
  CHECK(u.range == 1000);
  CHECK(u.step == converter_step(1000, 16));
  CHECK(u.hysteresis == Approx(0.5));
  CHECK(p.back_controller.time_constant_s == 9);
  CHECK(p.back_controller.pressure_resolution_pa == 1e3);
  CHECK(p.cell_controller.capacity_m3 == Approx(200e-6));
  CHECK(p.transducers[index(Quantity::back_volume)].step == 1);
  CHECK(p.frame.stiffness_n_per_m == Approx(20e6));
}

TEST_CASE("controllers and frames that cannot be are refused at the key") {
  const auto controller = [](const std::string& lines) {
    return complaint_of_rig("[rig.cell_controller]\n" + lines);
  };
  CHECK_THAT(controller("volume_rate_limit_mm3_per_s = 5"),
             Contains("p.toml:15") && Contains("needs fluid_compliance_mm3_per_kPa"));
  CHECK_THAT(controller("start_volume_cm3 = 5"),
             Contains("p.toml:15") && Contains("needs capacity_cm3"));
  CHECK_THAT(controller("capacity_cm3 = 200\nstart_volume_cm3 = 201"),
             Contains("p.toml:16") && Contains("capacity of 200 cm3"));
  CHECK_THAT(controller("pressure_resolution_kPa = 4000"), Contains("coarser"));
  for (const char* line :
       {"time_constant_s = -1", "fluid_compliance_mm3_per_kPa = -1", "capacity_cm3 = -1",
        "time_constant_s = 5e-324", "leak_mm3_per_min_at_100kPa = -1", "leak = 1",
        "pressure_resolution_kPa = -1"})
    CHECK_THAT(controller(line), Contains("p.toml:15"));
  for (const char* line :
       {"velocity_step_mm_per_min = 7", "stiffness_kN_per_mm = -1", "load_limit_N = -1",
        "bandwidth_Hz = 1e-9", "moving_mass_kg = -1", "damping_N_s_per_m = -1", "stiffness = 3"})
    CHECK_THAT(complaint_of_rig(std::string("[rig.frame]\n") + line), Contains("p.toml:15"));
  CHECK_THAT(complaint_of_rig("instruments = \"standart\""),
             Contains("p.toml:14") && Contains("did you mean 'standard'?"));
}

TEST_CASE("a controller whose water gives way needs a drainage that holds the flow back") {
  const auto rig = [](const std::string& resistance, const std::string& which) {
    return complaint_of_rig("drainage_resistance_kPa_s_per_mm3 = " + resistance + "\n[rig." +
                            which + "]\nfluid_compliance_mm3_per_kPa = 5\n");
  };
  for (const char* which : {"cell_controller", "back_controller"}) {
    CHECK(rig("0.05", which) == "accepted");
    CHECK_THAT(rig("0.049", which),
               Contains("p.toml:14") && Contains("at least 0.05 with a controller"));
  }
  CHECK_THAT(complaint_of_rig("instruments = \"standard\""), Contains("at least 0.0833"));
}

TEST_CASE("0 takes back what a set of instruments gives") {
  const Programme p = with_rig(R"(instruments = "standard"
[rig.frame]
stiffness_kN_per_mm = 0
load_limit_N = 0
bandwidth_Hz = 0
velocity_step_mm_per_min = 0
[rig.cell_controller]
fluid_compliance_mm3_per_kPa = 0
volume_rate_limit_mm3_per_s = 0
[rig.back_controller]
pressure_resolution_kPa = 0
time_constant_s = 0
fluid_compliance_mm3_per_kPa = 0
capacity_cm3 = 0
volume_rate_limit_mm3_per_s = 0
)");
  CHECK(p.frame.stiffness_n_per_m == 0);
  CHECK(p.frame.load_limit_n == 0);
  CHECK(p.frame.bandwidth_hz == 0);
  CHECK(p.frame.velocity_step_m_per_s == 0);
  CHECK(p.back_controller.pressure_resolution_pa == 0);
  CHECK(p.back_controller.time_constant_s == 0);
  CHECK(p.back_controller.capacity_m3 == 0);
  CHECK(p.cell_controller.fluid_compliance_m3_per_pa == 0);
}
