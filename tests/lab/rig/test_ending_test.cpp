// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;
using namespace triax::lab::test;
using Catch::Contains;
using Kind = TestEnding::Kind;

namespace {

TestEnding ending_of(const std::string& programme) {
  VirtualRig rig(read_programme(programme, "p.toml"));
  for (Reading reading; rig.next(reading);) {
  }
  return rig.ending();
}

}  // namespace

TEST_CASE("RigSoftware::ending: completed by the end condition of its last stage", "[rig]") {
  const TestEnding ending = ending_of(programme_text());
  CHECK(ending.kind == Kind::completed);
  CHECK(ending.reason.empty());
}

TEST_CASE("RigSoftware::ending: unfinished by the time limit of a stage", "[rig]") {
  const TestEnding ending =
      ending_of(replaced(programme_text(), "end = [", "time_limit_min = 0.2\nend = ["));
  CHECK(ending.kind == Kind::unfinished);
  CHECK_THAT(ending.reason, Contains("did not reach its end within 0.2 min"));
}

TEST_CASE("RigSoftware::ending: unfinished at the end of the travel", "[rig]") {
  const TestEnding ending = ending_of(programme_text() + "[rig.frame]\ntravel_mm = 1.0\n");
  CHECK(ending.kind == Kind::unfinished);
  CHECK_THAT(ending.reason, Contains("travel limit of 1 mm"));
}

TEST_CASE("RigSoftware::ending: safe state after the fault of a device", "[rig]") {
  const TestEnding ending =
      ending_of(programme_text() +
                "[[faults]]\ndevice = \"axial_displacement\"\nkind = \"stuck\"\nfrom_s = 20.0\n");
  CHECK(ending.kind == Kind::safe_state);
  CHECK_THAT(ending.reason, Contains("safe state from"));
}

TEST_CASE("RigSoftware::ending: aborted by the operator", "[rig]") {
  const TestEnding ending =
      ending_of(programme_text() + "[[operator]]\naction = \"abort\"\nat_min = 0.2\n");
  CHECK(ending.kind == Kind::aborted);
  CHECK_THAT(ending.reason, Contains("aborted by the operator"));
}
