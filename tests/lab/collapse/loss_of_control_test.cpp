// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/loss_of_control.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace triax::lab;

namespace {

const StageInfo kHeld{.number = 1,
                      .name = "csd",
                      .role = StageRole::shear,
                      .drainage = Drainage::open,
                      .control = AxialControl::constant_q};

State state_under_control(int reading, double q, double strain) {
  State s;
  s.reading = reading;
  s.time_s = reading;
  s.q = q;
  s.p_eff = 200e3;
  s.strain.axial = strain;
  return s;
}

}  // namespace

TEST_CASE("a held q that falls is loss of control; its noise is not") {
  std::mt19937_64 rng(8);
  std::normal_distribution<double> noise(0, 500);
  LossOfControl control;
  control.start_stage(&kHeld);
  for (int i = 0; i < 2000; ++i)
    control.add_state(state_under_control(i, 60e3 + noise(rng), i * 1e-6), true);
  CHECK_FALSE(control.finding());
  for (int i = 2000; i < 2050; ++i)
    control.add_state(state_under_control(i, 60e3 - (i - 2000) * 1e3 + noise(rng), i * 1e-6), true);
  REQUIRE(control.finding());
  CHECK(control.finding()->instant.reading > 2000);
  CHECK(control.finding()->instant.reading < 2010);
}

TEST_CASE("a burst of strain within one scan is loss of control under load") {
  StageInfo load = kHeld;
  load.control = AxialControl::load;
  LossOfControl control;
  control.start_stage(&load);
  for (int i = 0; i < 300; ++i) control.add_state(state_under_control(i, 50e3, i * 1e-5), true);
  CHECK_FALSE(control.finding());
  control.add_state(state_under_control(300, 5e3, 0.15), true);
  REQUIRE(control.finding());
  CHECK(control.finding()->instant.reading == 299);
  CHECK(control.sudden());
}

TEST_CASE("a loss is known at the reading taken by then, and in a later stage no later") {
  StageInfo load = kHeld;
  load.control = AxialControl::load;
  LossOfControl control;
  control.start_stage(&load);
  for (int i = 0; i < 300; ++i) control.add_state(state_under_control(i, 50e3, i * 1e-5), true);
  control.set_now(Moment{304, 304.0});  // four readings were held back
  control.start_stage(&load);
  for (int i = 300; i < 330; ++i) control.add_state(state_under_control(i, 50e3, i * 1e-5), true);
  control.set_now(Moment{331, 331.0});
  control.add_state(state_under_control(330, 5e3, 0.15), true);
  control.set_now(Moment{400, 400.0});
  control.start_stage(&kHeld);
  REQUIRE(control.finding());
  CHECK(control.finding()->instant.reading == 329);
  REQUIRE(control.finding()->noticed);
  CHECK(control.finding()->noticed->reading == 331);
  CHECK(control.finding()->noticed->time_s == 331.0);

  LossOfControl late;
  late.start_stage(&load);
  for (int i = 0; i < 300; ++i) late.add_state(state_under_control(i, 50e3, i * 1e-5), true);
  late.set_now(std::nullopt);  // the record is over
  late.add_state(state_under_control(300, 5e3, 0.15), true);
  REQUIRE(late.finding());
  CHECK_FALSE(late.finding()->noticed);
}

TEST_CASE("a burst with which a load grew, and is carried on, took no control away") {
  StageInfo load = kHeld;
  load.control = AxialControl::load;
  LossOfControl control;
  control.start_stage(&load);
  const auto add = [&](int i, double q, double strain) {
    control.add_state(state_under_control(i, q, strain), true);
  };
  int i = 0;
  for (; i < 300; ++i) add(i, 98e3 + 10 * i, i * 1e-5);
  add(i, 103e3, 0.03);
  REQUIRE(control.lost());
  for (const int end = i + 40; ++i < end;) add(i, 100e3 + 10 * i, 0.03 + i * 1e-5);
  CHECK_FALSE(control.lost());
  REQUIRE(control.finding());
  CHECK_FALSE(control.finding()->detected);
  // Far beyond the load of then the next burst is looked for; this one is told as before.
  for (; i < 900; ++i) add(i, 100e3 + 10 * i, 0.03 + i * 1e-5);
  CHECK_FALSE(control.found());
  REQUIRE(control.finding());
  CHECK_FALSE(control.finding()->detected);
  add(i, 20e3, 0.2);
  REQUIRE(control.lost());
  CHECK(control.lost()->instant.reading == 899);
}

TEST_CASE(
    "a load that grows on at a constant q, on a growing area, is carried; one that stays is not") {
  StageInfo load = kHeld;
  load.control = AxialControl::load;
  const auto lost = [&](double force_growth) {
    LossOfControl control;
    control.start_stage(&load);
    for (int i = 0; i < 30; ++i)
      control.add_state(state_under_control(i, 10e3 * i, i * 2e-4), true);
    for (int i = 1; i <= 8; ++i) {
      const double strain = 6e-3 + 0.02 * i;
      State state =
          state_under_control(29 + i, 300e3 * (1 + force_growth * i) * (1 - strain), strain);
      state.strain.radial = -strain / 2;
      control.add_state(state, true);
    }
    return control.lost().has_value();
  };
  CHECK_FALSE(lost(0.025));
  CHECK(lost(0));
}

TEST_CASE("what a burst was is decided by its own stage, and not before the record shows it") {
  StageInfo load = kHeld, later = kHeld;
  load.control = AxialControl::load;
  later.control = AxialControl::displacement;
  LossOfControl control;
  control.start_stage(&load);
  const auto add = [&](int i, double q, double strain) {
    control.add_state(state_under_control(i, q, strain), true);
  };
  int i = 0;
  for (; i < 300; ++i) add(i, 98e3 + 10 * i, i * 1e-5);
  for (const int end = i + 3; i < end; ++i) add(i, 100e3 + 10 * i, 0.03 + i * 1e-5);
  CHECK(control.lost());  // three readings say nothing against it
  for (const int end = i + 20; i < end; ++i) add(i, 100e3 + 10 * i, 0.03 + i * 1e-5);
  CHECK_FALSE(control.lost());
  control.start_stage(&later);  // unloading
  for (const int end = i + 20; i < end; ++i) add(i, 10e3, 0.03);
  CHECK_FALSE(control.lost());

  // Lost while q was held: no later load takes that back.
  LossOfControl held;
  held.start_stage(&kHeld);
  for (i = 0; i < 300; ++i) held.add_state(state_under_control(i, 50e3, i * 1e-5), true);
  held.add_state(state_under_control(i, 50e3, 0.1), true);
  REQUIRE(held.lost());
  held.start_stage(&load);
  for (const int end = i + 40; i < end; ++i)
    held.add_state(state_under_control(i, 80e3, 0.1), true);
  REQUIRE(held.lost());
  CHECK(held.lost()->instant.reading == 299);
  CHECK(held.loss()->came_back());
}

TEST_CASE("a load that fell in a burst was lost, whatever comes later") {
  StageInfo load = kHeld;
  load.control = AxialControl::load;
  LossOfControl control;
  control.start_stage(&load);
  for (int i = 0; i < 300; ++i) control.add_state(state_under_control(i, 100e3, i * 1e-5), true);
  control.add_state(state_under_control(300, 60e3, 0.05), true);
  for (int i = 301; i < 400; ++i) control.add_state(state_under_control(i, 101e3, 0.06), true);
  CHECK(control.lost());
}

TEST_CASE("where nobody says what is prescribed, a leap beyond any frame with q falling counts") {
  StageInfo unsaid = kHeld;
  unsaid.control = AxialControl::unknown;
  const auto found = [&](double step, double q_after, bool has_time) {
    LossOfControl control;
    control.start_stage(&unsaid);
    for (int i = 0; i < 300; ++i)
      control.add_state(state_under_control(i, 50e3, i * 1e-4), has_time);
    control.add_state(state_under_control(300, q_after, 299e-4 + step), has_time);
    return control.finding().has_value();
  };
  for (const bool has_time : {true, false}) {
    CHECK(found(0.1, 1e3, has_time));
    CHECK_FALSE(found(0.1, 60e3, has_time));   // the drive went faster, the specimen carries
    CHECK_FALSE(found(1e-4, 1e3, has_time));   // brittle, at the rate of the drive
    CHECK_FALSE(found(5e-4, 40e3, has_time));  // read less often
  }
}

TEST_CASE("a specimen that falls before the stage has shown a rate has lost control all the same") {
  StageInfo load = kHeld;
  load.control = AxialControl::load;
  const auto finding = [&](int standing, const State& after) {
    StageInfo displacement = kHeld;
    displacement.control = AxialControl::displacement;
    LossOfControl control;
    control.start_stage(&displacement);
    for (int i = 0; i < 100 - standing; ++i)
      control.add_state(state_under_control(i, 40e3, i * 1e-5), true);
    control.start_stage(&load);
    for (int i = 100 - standing; i < 100; ++i)
      control.add_state(state_under_control(i, 40e3, 1e-3), true);
    CHECK_FALSE(control.finding());
    control.add_state(after, true);
    CHECK_FALSE(control.sudden());
    CHECK(control.lost().has_value() == control.found().has_value());
    return control.finding();
  };
  for (const int standing : {0, 1, 10}) {
    INFO(standing);
    const auto found = finding(standing, state_under_control(100, 2e3, 0.15));
    REQUIRE(found);
    CHECK(found->instant.reading == 99);
    CHECK(found->evidence.find("axial strain jumped from") == 0);
    // A load step that the specimen carries is told; a displacement set to zero, a blow that
    // settles and a pause of the logger are not.
    REQUIRE(finding(standing, state_under_control(100, 60e3, 0.02)));
    CHECK_FALSE(finding(standing, state_under_control(100, 60e3, 0.02))->detected);
    CHECK_FALSE(finding(standing, state_under_control(100, 39e3, 0.15)));
    CHECK_FALSE(finding(standing, state_under_control(100, 36e3, 0.002)));
    CHECK_FALSE(finding(standing, state_under_control(110, 2e3, 0.15)));
  }
}

TEST_CASE("what creeps faster before a fall is not yet the fall") {
  LossOfControl control;
  control.start_stage(&kHeld);
  for (int i = 0; i < 300; ++i) control.add_state(state_under_control(i, 60e3, i * 1e-6), true);
  double strain = 299e-6;
  for (int i = 300; i < 304; ++i)
    control.add_state(state_under_control(i, 60e3, strain += 2e-5), true);
  CHECK_FALSE(control.finding());
  control.add_state(state_under_control(304, 1e3, 0.15), true);
  REQUIRE(control.finding());
  CHECK(control.finding()->instant.reading == 303);
  CHECK(control.sudden());
}

TEST_CASE("a burst over many readings is no fall") {
  LossOfControl control;
  control.start_stage(&kHeld);
  for (int i = 0; i < 300; ++i) control.add_state(state_under_control(i, 60e3, i * 1e-6), true);
  for (int i = 300; i < 320; ++i)
    control.add_state(state_under_control(i, 60e3, 3e-4 + (i - 299) * 5e-4), true);
  REQUIRE(control.finding());
  CHECK_FALSE(control.sudden());
}

TEST_CASE("a prescribed displacement is never lost") {
  StageInfo displacement = kHeld;
  displacement.control = AxialControl::displacement;
  LossOfControl control;
  control.start_stage(&displacement);
  for (int i = 0; i < 300; ++i) control.add_state(state_under_control(i, 50e3, i * 1e-5), true);
  control.add_state(state_under_control(300, 5e3, 0.15), true);
  CHECK_FALSE(control.finding());
}

TEST_CASE("a logger that slows down makes no burst of a steady creep") {
  StageInfo load = kHeld;
  load.control = AxialControl::load;
  LossOfControl control;
  control.start_stage(&load);
  State s = state_under_control(0, 50e3, 0);
  for (int i = 0; i < 600; ++i) {
    s.reading = i;
    s.time_s += i < 300 ? 1 : 120;
    s.strain.axial = 1e-5 * s.time_s;
    control.add_state(s, true);
  }
  CHECK_FALSE(control.finding());
}

namespace {

/// A stage at held q in which u and σ₃′ follow `pore` and `cell`, Pa by reading.
template <class Pore, class Cell>
std::optional<Finding> pore_finding(Drainage drainage, int readings, Pore pore, Cell cell) {
  StageInfo stage = kHeld;
  stage.drainage = drainage;
  LossOfControl control;
  control.start_stage(&stage);
  for (int i = 0; i < readings; ++i) {
    State s = state_under_control(i, 60e3, i * 1e-6);
    s.pore_pressure = pore(i);
    s.effective_stress = {cell(i) - pore(i) + 60e3, cell(i) - pore(i)};
    control.add_state(s, true);
  }
  return control.finding();
}

}  // namespace

TEST_CASE("a burst of pore pressure is loss of control, where it begins") {
  const auto burst = [](int i) { return 300e3 + 10.0 * i + (i > 400 ? 5e3 * (i - 400) : 0.0); };
  const auto steady = [](int) { return 500e3; };
  for (const Drainage drainage : {Drainage::open, Drainage::closed}) {
    const auto finding = pore_finding(drainage, 500, burst, steady);
    REQUIRE(finding);
    CHECK(finding->instant.reading == 400);
    CHECK(finding->evidence.find("pore pressure increased") == 0);
    CHECK_FALSE(pore_finding(drainage, 400, burst, steady));
  }
}

TEST_CASE("pore pressure that goes where the programme sends it is no loss of control") {
  // Closed: it follows a sudden rise of the cell pressure. Open: it rises at the pace that it has
  // had from the start, whatever that pace is.
  const auto step = [](int i) { return i > 400 ? 40e3 : 0.0; };
  CHECK_FALSE(pore_finding(
      Drainage::closed, 500, [&](int i) { return 300e3 + step(i); },
      [&](int i) { return 500e3 + step(i); }));
  CHECK_FALSE(pore_finding(
      Drainage::open, 500, [](int i) { return 100e3 + 300.0 * i; }, [](int) { return 700e3; }));
  // A fall is not the sign that is looked for.
  CHECK_FALSE(pore_finding(
      Drainage::closed, 500, [&](int i) { return 300e3 - step(i); }, [](int) { return 500e3; }));
}
