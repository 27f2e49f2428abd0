// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/rig_guard.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

/// A stage under load between two by displacement.
GuardedProgramme of_three_stages(Guard::Action action) {
  Programme programme;
  programme.guard = Guard{.on = WarningLevel::imminent, .action = action};
  programme.stages.resize(3);
  for (Stage& stage : programme.stages) {
    stage.role = StageRole::shear;
    stage.axial = AxialAction::displacement;
  }
  programme.stages[1].axial = AxialAction::load;
  return with_guard_stages(programme);
}

}  // namespace

TEST_CASE("a guard is due from its level on, in a stage that it guards, and acts once") {
  const GuardedProgramme all = of_three_stages(Guard::Action::hand_over);
  const std::vector<Stage>& stages = all.programme.stages;
  RigGuard guard(all);
  CHECK_FALSE(guard.is_due(1, stages[1]));
  guard.hear(WarningLevel::approaching);
  CHECK_FALSE(guard.is_due(1, stages[1]));
  guard.hear(WarningLevel::imminent);
  CHECK_FALSE(guard.is_due(0, stages[0]));
  CHECK(guard.is_due(1, stages[1]));
  CHECK_FALSE(guard.take_news());
  CHECK(guard.act().action == Guard::Action::hand_over);
  CHECK_FALSE(guard.is_due(1, stages[1]));
  CHECK_FALSE(guard.unloads());
  CHECK_THAT(guard.take_news().value_or(""), Catch::Contains("switched"));
  CHECK_FALSE(guard.take_news());
}

TEST_CASE("the stages of a guard take over from those it guards, and none follows them") {
  const GuardedProgramme all = of_three_stages(Guard::Action::hand_over);
  REQUIRE(all.programme.stages.size() == 4);
  RigGuard guard(all);
  CHECK(guard.is_followed(0));
  CHECK(guard.is_followed(1));
  CHECK_FALSE(guard.is_followed(2));
  CHECK_FALSE(guard.is_followed(3));
  CHECK(guard.successor(1) == 3);
  guard.hear(WarningLevel::lost);
  CHECK_FALSE(guard.is_due(3, all.programme.stages[1]));  // none guards the guard's own
}

TEST_CASE("q is being taken back once a guard that unloads has acted") {
  RigGuard guard(of_three_stages(Guard::Action::unload));
  guard.hear(WarningLevel::lost);
  CHECK_FALSE(guard.unloads());
  guard.act();
  CHECK(guard.unloads());
}

TEST_CASE("a programme without a guard has none that could be due") {
  GuardedProgramme none = of_three_stages(Guard::Action::hold);
  none.programme.guard.reset();
  RigGuard guard(none);
  guard.hear(WarningLevel::lost);
  CHECK_FALSE(guard.is_due(1, none.programme.stages[1]));
  CHECK_FALSE(guard.unloads());
}
