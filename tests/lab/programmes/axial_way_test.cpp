// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/axial_way.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "lab/programmes/programme.hpp"

using namespace triax::lab;

TEST_CASE("the ways to drive the axis are in the order of the enumeration, each with its word") {
  std::set<std::string_view> words;
  for (std::size_t i = 0; i < axial_ways().size(); ++i) {
    CHECK(static_cast<std::size_t>(axial_ways()[i].action) == i);
    words.insert(axial_ways()[i].word);
  }
  CHECK(words.size() == axial_ways().size());
  CHECK(way_of(AxialAction::stress_ratio).word == "stress_ratio");
}

TEST_CASE("a servo follows a force or a stress, and looks at the load cell for it") {
  for (const AxialWay& way : axial_ways()) {
    INFO(way.word);
    const bool servo = way.drive == AxialWay::Drive::servo;
    CHECK(servo == ((way.force != nullptr) != (way.stress != nullptr)));
    CHECK(servo == (!way.looks_at.empty() && way.looks_at.front() == Quantity::axial_force));
    CHECK(by_force(way.action) == (servo || way.drive == AxialWay::Drive::masses));
  }
}

TEST_CASE("what a servo wants follows from the stage and what it sees") {
  Stage stage;
  stage.load_rate_n_per_s = 2;
  stage.load_step_n = 5;
  stage.held_stress_ratio = 0.75;
  const AxisView view{.force_at_start_n = 100,
                      .q_at_start_pa = 60e3,
                      .stage_time_s = 10,
                      .cell_pa = 400e3,
                      .pore_pa = 310e3};
  CHECK(way_of(AxialAction::load).force(stage, view) == 125);
  CHECK(way_of(AxialAction::constant_q).stress(stage, view) == 60e3);
  const double q = way_of(AxialAction::stress_ratio).stress(stage, view);
  CHECK(q / (90e3 + q / 3) == Approx(0.75));
  stage.held_q_pa = 20e3;
  CHECK(way_of(AxialAction::constant_q).stress(stage, view) == 20e3);
}
