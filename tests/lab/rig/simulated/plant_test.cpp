// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/plant.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/rig/rig_text.hpp"

using namespace triax;
using namespace triax::lab;
using namespace triax::lab::test;

namespace {

Programme plain(const std::string& rig = kIdealFrame) {
  return rig_programme(shear_stage("closed", "displacement", "axial_rate_mm_per_min = 1.0",
                                   R"("q_kPa", above = 1.0)"),
                       rig);
}

PlantDemand moving(double velocity_m_per_s, bool valve_open) {
  PlantDemand demand;
  demand.axis.kind = AxisDemand::Kind::crosshead;
  demand.axis.velocity_m_per_s = velocity_m_per_s;
  demand.valve_open = valve_open;
  return demand;
}

/// So many ticks of 0.25 s.
void advance(Plant& plant, const PlantDemand& demand, int ticks, double from_s = 0) {
  for (int i = 0; i < ticks; ++i) plant.advance(demand, from_s + 0.25 * i, 0.25);
}

}  // namespace

TEST_CASE("a plant begins at rest, consolidated as the programme says") {
  const Plant plant(plain());
  CHECK(plant.true_value(Quantity::cell_pressure) == 400e3);
  CHECK(plant.true_value(Quantity::back_pressure) == 300e3);
  CHECK(plant.true_value(Quantity::pore_pressure) == 300e3);
  for (const Quantity zero : {Quantity::axial_displacement, Quantity::axial_force,
                              Quantity::back_volume, Quantity::cell_volume})
    CHECK(plant.true_value(zero) == Approx(0).margin(1e-18));
  CHECK(plant.last_step().done_s == 0);
}

TEST_CASE("closed, a moved crosshead raises force and pore pressure and no water flows") {
  Plant plant(plain());
  advance(plant, moving(1e-5, false), 40);
  CHECK(plant.true_value(Quantity::axial_displacement) == Approx(1e-4).epsilon(1e-12));
  CHECK(plant.true_value(Quantity::axial_force) > 20);
  CHECK(plant.true_value(Quantity::pore_pressure) > 301e3);
  CHECK(plant.true_value(Quantity::back_volume) == 0);
  CHECK(plant.true_value(Quantity::cell_volume) == Approx(0).margin(1e-15));
  CHECK(plant.last_step().work.axial > 0);
  CHECK(plant.state().cylinder_force_n == plant.true_value(Quantity::axial_force));
}

TEST_CASE(
    "open, what leaves the specimen goes into the back controller, what it gives up the cell "
    "fills") {
  Plant plant(plain());
  advance(plant, moving(1e-5, true), 40);
  const auto& specimen = plant.specimen();
  const double shrunk =
      specimen.volume_m3(specimen.start()) - specimen.volume_m3(plant.state().specimen);
  CHECK(shrunk > 1e-9);
  CHECK(plant.true_value(Quantity::pore_pressure) == 300e3);
  CHECK(plant.true_value(Quantity::back_volume) == Approx(-shrunk).epsilon(1e-9));
  CHECK(plant.true_value(Quantity::cell_volume) == Approx(shrunk).epsilon(1e-9));
}

TEST_CASE("volume control drives what flows out of the specimen") {
  Plant plant(plain());
  PlantDemand demand = moving(0, true);
  demand.outflow_m3_per_s = 1e-9;
  advance(plant, demand, 40);
  CHECK(plant.true_value(Quantity::back_volume) == Approx(-1e-8).epsilon(1e-9));
  CHECK(plant.true_value(Quantity::pore_pressure) < 300e3);
}

TEST_CASE("faults: a frame that is stuck, a valve that does not open or close") {
  Programme programme = plain();
  programme.faults = {{.device = "frame", .kind = FaultKind::stuck, .from_s = 5}};
  Plant stuck(programme);
  advance(stuck, moving(1e-5, false), 40);
  CHECK(stuck.true_value(Quantity::axial_displacement) == Approx(5e-5).epsilon(1e-12));

  programme.faults = {{.device = "valve", .kind = FaultKind::does_not_open}};
  Plant closed(programme);
  advance(closed, moving(1e-5, true), 40);
  CHECK(closed.true_value(Quantity::back_volume) == 0);
  programme.faults = {{.device = "valve", .kind = FaultKind::does_not_close}};
  Plant open(programme);
  advance(open, moving(1e-5, false), 40);
  CHECK(open.true_value(Quantity::back_volume) < 0);
}

TEST_CASE("a force that is not carried leaves the plant as it was") {
  Plant plant(plain());  // nothing moves that has a mass
  advance(plant, moving(1e-5, false), 400);
  PlantDemand demand;
  demand.valve_open = false;
  demand.axis.kind = AxisDemand::Kind::force;
  demand.axis.start_force_n = plant.true_value(Quantity::axial_force);
  demand.axis.force_n = demand.axis.start_force_n + 500;
  const double height = plant.state().specimen.height_m;
  const auto& step = plant.advance(demand, 100, 0.25);
  CHECK(step.outcome == sim::StepOutcome::lost_control);
  CHECK(plant.state().specimen.height_m == height);
  CHECK(plant.state().cylinder_force_n == demand.axis.start_force_n);
}

TEST_CASE("a spring keeps what it holds while the cap runs away through many ticks") {
  constexpr double kSpring = 2e3, kVelocity = 1e-5;  // N/m, softer than the specimen softens; m/s
  Programme programme = plain();
  programme.frame.moving_mass_kg = 2000;  // so that it takes its time
  Plant plant(programme);
  advance(plant, moving(kVelocity, false), 480);
  const sim::SpecimenState start = plant.state().specimen;  // past the peak of q
  const double force = plant.specimen().axial_force(start);
  PlantDemand sprung = moving(kVelocity, false);
  sprung.axis.spring_n_per_m = kSpring;
  int ticks = 0;
  do {
    plant.advance(sprung, 120 + 0.25 * ticks, 0.25);
    ++ticks;
    const auto& now = plant.state().specimen;
    const double crosshead = kVelocity * 0.25 * ticks, cap = start.height_m - now.height_m;
    CHECK(now.applied_force_n == Approx(force + kSpring * (crosshead - cap)).epsilon(1e-9));
  } while (plant.state().specimen.run_away.under_way && ticks < 100);
  CHECK(ticks > 3);
  CHECK(plant.state().specimen.run_away.count == 1);
}

TEST_CASE("the transducer outside sees the load cell shorten, the crosshead the frame too") {
  Plant plant(
      plain("[rig.frame]\nstiffness_kN_per_mm = 10.0\nload_cell_stiffness_kN_per_mm = 5.0\n"));
  advance(plant, moving(1e-5, false), 40);
  const double force = plant.true_value(Quantity::axial_force);
  const double shortening = 0.14 - plant.state().specimen.height_m;
  CHECK(plant.true_value(Quantity::axial_displacement) ==
        Approx(shortening + force / 5e6).epsilon(1e-9));
  CHECK(1e-4 == Approx(shortening + force / 5e6 + force / 10e6).epsilon(1e-6));
}

TEST_CASE("the cell pressure of the next tick is known before it comes") {
  const Programme programme = plain();
  Plant plant(programme);
  const auto next_pa = [&](const PressureDemand& demand) {
    return process(programme.cell_controller, plant.state().cell.asked_pa, demand, 0.25);
  };
  PlantDemand demand = moving(0, false);
  demand.cell = {.rate_pa_per_s = 1e3, .target_pa = 400.4e3};
  CHECK(next_pa(demand.cell) == Approx(400.25e3));
  plant.advance(demand, 0, 0.25);
  CHECK(plant.true_value(Quantity::cell_pressure) == Approx(400.25e3));
  CHECK(next_pa(demand.cell) == 400.4e3);
}

TEST_CASE("a force follows the area within the tick where it is given as a stress") {
  Plant plant(plain());
  PlantDemand demand;
  demand.axis.kind = AxisDemand::Kind::force;
  demand.axis.area_m2 = plant.specimen().area_m2(plant.state().specimen);
  demand.axis.stress_pa = 30e3;
  plant.advance(demand, 0, 0.25);
  const auto& s = plant.state().specimen;
  CHECK(s.material.q() == Approx(30e3).epsilon(1e-9));
  CHECK(plant.specimen().area_m2(s) != Approx(demand.axis.area_m2).epsilon(1e-6));
}
