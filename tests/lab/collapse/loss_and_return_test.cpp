// SPDX-License-Identifier: GPL-3.0-or-later
// In closed form; what a monitor makes of it: runaway_and_return_test.cpp.
#include "lab/collapse/loss_and_return.hpp"

#include <catch2/catch.hpp>
#include <tuple>

using namespace triax::lab;

namespace {

/// With σ₃' of 100 kPa.
State with_q(double q_kPa, double radial_kPa = 100) {
  State state;
  state.q = q_kPa * 1e3;
  state.effective_stress.radial = radial_kPa * 1e3;
  return state;
}

/// Ran at 150 kPa into compression.
LossAndReturn ran(Drainage drainage = Drainage::closed) { return {with_q(150), 0.05, drainage}; }

void stay(LossAndReturn& loss, double q_kPa, int readings = 100, double radial_kPa = 100) {
  for (int i = 0; i < readings; ++i) loss.add(with_q(q_kPa, radial_kPa));
}

StageInfo later_stage(Drainage drainage, StageRole role = StageRole::shear) {
  StageInfo stage;
  stage.role = role;
  stage.drainage = drainage;
  return stage;
}

}  // namespace

TEST_CASE("what was lost and what came back, as shares of the strength before") {
  LossAndReturn loss = ran();
  CHECK(loss.lost() == 0);
  CHECK(loss.regained() == 0);
  CHECK_FALSE(loss.came_back());
  stay(loss, 30);
  CHECK(loss.lost() == Approx(0.8));
  CHECK(loss.least() == Approx(30e3));
  CHECK(loss.regained() == 0);
  stay(loss, 180);
  CHECK(loss.regained() == Approx(1.0));
  CHECK(loss.largest_since() == Approx(180e3));
  CHECK(loss.lost() == Approx(0.8));
}

TEST_CASE("it came back from half of the loss on, and from a twentieth of the strength before") {
  for (const auto& [least, most, back] : {std::tuple{30.0, 88.0, false},
                                          {30.0, 92.0, true},
                                          {147.0, 154.0, false},
                                          {147.0, 155.0, true}}) {
    LossAndReturn loss = ran();
    stay(loss, least);
    stay(loss, most);
    INFO(least << " to " << most);
    CHECK(loss.came_back() == back);
  }
}

TEST_CASE("one reading is a spike; of two in a row the lesser counts") {
  LossAndReturn loss = ran();
  stay(loss, 60);
  loss.add(with_q(140));
  CHECK(loss.largest_since() == Approx(60e3));
  loss.add(with_q(130));
  CHECK(loss.largest_since() == Approx(130e3));
}

TEST_CASE("a deeper fall begins the return anew") {
  LossAndReturn loss = ran();
  stay(loss, 75);
  stay(loss, 120);
  CHECK(loss.came_back());
  stay(loss, 15);
  CHECK(loss.lost() == Approx(0.9));
  CHECK(loss.regained() == 0);
  CHECK_FALSE(loss.came_back());
}

TEST_CASE("beyond zero all of the strength is lost, and no more than all") {
  LossAndReturn loss = ran();
  stay(loss, -40);
  CHECK(loss.lost() == 1);
  stay(loss, 60);
  CHECK(loss.regained() == Approx(0.4));
}

TEST_CASE("in extension strength is lost and comes back with q < 0") {
  LossAndReturn loss(with_q(-80), -0.05, Drainage::closed);
  stay(loss, -20);
  CHECK(loss.lost() == Approx(0.75));
  stay(loss, 70);
  CHECK_FALSE(loss.came_back());
  LossAndReturn small(with_q(-80), 9e-4, Drainage::closed);  // a leap that tells no direction
  stay(small, -20);
  stay(small, -70);
  CHECK(small.came_back());
}

TEST_CASE("what the scatter of the load cell may be is no return") {
  for (const double scatter : {0.0, 0.5, 1.5}) {  // BendNoise: twice of that, to and fro
    LossAndReturn loss = ran();
    for (int i = 0; i < 400; ++i)
      loss.add(with_q((i < 200 ? 100 : 130) + (i % 2 == 0 ? scatter : -scatter)));
    INFO(scatter);
    CHECK(loss.came_back() == (scatter < 1));
  }
}

TEST_CASE("a later stage tells of strength that comes back, not of more that is lost") {
  LossAndReturn loss = ran();
  stay(loss, 60);
  const StageInfo shear = later_stage(Drainage::closed);
  loss.start_stage(&shear);
  stay(loss, 10);
  CHECK(loss.lost() == Approx(0.6));
  stay(loss, 140);
  CHECK(loss.came_back());
}

TEST_CASE("nothing comes back of a specimen that was made another") {
  const auto back_in = [](const StageInfo* stage) {
    LossAndReturn loss = ran();
    stay(loss, 60);
    loss.start_stage(stage);
    stay(loss, 300);
    return loss.came_back();
  };
  const StageInfo shut = later_stage(Drainage::closed), opened = later_stage(Drainage::open),
                  consolidated = later_stage(Drainage::closed, StageRole::consolidation);
  CHECK(back_in(&shut));
  CHECK_FALSE(back_in(&opened));
  CHECK_FALSE(back_in(&consolidated));
}

TEST_CASE("where water could flow a cell pressure raised by a tenth makes it another") {
  for (const auto& [drainage, radial_kPa, back] : {std::tuple{Drainage::open, 109.0, true},
                                                   {Drainage::open, 111.0, false},
                                                   {Drainage::unknown, 111.0, false},
                                                   {Drainage::closed, 300.0, true}}) {
    LossAndReturn loss = ran(drainage);
    stay(loss, 60);
    stay(loss, 140, 100, radial_kPa);
    INFO(radial_kPa);
    CHECK(loss.came_back() == back);
  }
}

TEST_CASE("readings without q are passed over; without strength before nothing can be lost") {
  LossAndReturn loss = ran();
  loss.add(with_q(60));
  loss.add(with_q(kMissing));
  CHECK(loss.lost() == Approx(0.6));
  loss.add(with_q(140));  // one so far
  CHECK(loss.largest_since() == Approx(60e3));
  loss.add(with_q(kMissing));
  loss.add(with_q(140));
  CHECK(loss.largest_since() == Approx(140e3));
  CHECK(loss.came_back());
  for (const double none : {0.0, kMissing}) {
    LossAndReturn nothing(with_q(none), 0.05, Drainage::closed);
    stay(nothing, 50);
    CHECK(nothing.lost() == 0);
    CHECK(nothing.regained() == 0);
    CHECK_FALSE(nothing.came_back());
  }
}
