// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/operator_reader.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "lab/base/bad_input.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;
using Catch::Contains;

namespace {

std::string action(const std::string& word, double at_min) {
  return "[[operator]]\naction = \"" + word + "\"\nat_min = " + std::to_string(at_min) + "\n";
}

std::string complaint_of_actions(const std::string& actions) {
  try {
    read_programme(test::programme_text() + actions, "p.toml");
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("what the operator does is read in SI, in the order of time") {
  const Programme p = read_programme(
      test::programme_text() + action("hold", 1) + action("resume", 2.5) + action("abort", 3),
      "p.toml");
  REQUIRE(p.operator_actions.size() == 3);
  CHECK(p.operator_actions[0].kind == OperatorAction::Kind::hold);
  CHECK(p.operator_actions[1].at_s == 150);
  CHECK(p.operator_actions[2].kind == OperatorAction::Kind::abort);
}

TEST_CASE("an order that nobody can follow is refused") {
  CHECK_THAT(complaint_of_actions(action("pause", 1)),
             Contains("must be one of: hold, resume, abort"));
  CHECK_THAT(complaint_of_actions(action("resume", 1)), Contains("no hold to resume"));
  CHECK_THAT(complaint_of_actions(action("hold", 1) + action("hold", 2)), Contains("held already"));
  CHECK_THAT(complaint_of_actions(action("hold", 1)), Contains("this hold does not end"));
  CHECK_THAT(complaint_of_actions(action("hold", 2) + action("resume", 1)),
             Contains("must be later"));
  CHECK_THAT(complaint_of_actions(action("abort", 1) + action("hold", 2)),
             Contains("after an abort"));
}
