// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe_text.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "src/probe/probe_json.hpp"
#include "tests/src/sample_probes.hpp"

using namespace triax;
using nlohmann::json;

namespace {

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

}  // namespace

TEST_CASE("the text has the probes only where they are asked for") {
  const auto result = src::test::inl2_probes({0.6});
  CHECK(lines(src::probe_text(result, {.probes = true})) >
        lines(src::probe_text(result, {})) + result.states[0].circle.probes.size());
}

TEST_CASE("of many states outside the range the first is named, and how many there are") {
  auto result = src::test::inl2_probes({0.1});
  for (const double p_kPa : {5.0, 4.0, 3.0})
    result.states.push_back(
        study::run_probe(src::test::inl2_request({0.1}, {}, false, p_kPa)).states.front());
  result.many = true;
  const std::string text = src::probe_text(result, {});
  CHECK(text.find("p' is 5 kPa, outside the range 10 to 1000 kPa of inl2/S28-general, and so at 2 "
                  "more of the states") != std::string::npos);
  CHECK(text.find("p' is 4 kPa") == std::string::npos);
}

TEST_CASE("a warning of path and state alike is told once, and so is the head") {
  auto result = src::test::inl2_probes({0.6});
  result.warnings = result.states[0].warnings = {"a state of its own kind"};
  const std::string text = src::probe_text(result, {});
  for (const std::string once : {"a state of its own kind", "Second-order work in every"}) {
    const auto at = text.find(once);
    REQUIRE(at != std::string::npos);
    CHECK(text.find(once, at + 1) == std::string::npos);
  }
}

TEST_CASE("the first unstable state of a list is that of least |eta|, in whatever order") {
  const auto result = src::test::inl2_probes({0.8, 0.6, 0.3, 0.7});
  const auto first = result.first_unstable();
  REQUIRE(first);
  CHECK(first->eta() == Approx(0.6));
  CHECK(src::probe_text(result, {}).find("unstable state (smallest |η|): p′ 70.00 kPa, q 42.00") !=
        std::string::npos);
  auto tests = result;
  for (auto& state : tests.states) state.test = src::test::tested(3.7);
  CHECK_FALSE(tests.first_unstable());
  CHECK(src::probe_text(tests, {}).find("unstable state") == std::string::npos);
  CHECK_FALSE(json::parse(src::probe_json(tests)).contains("first_unstable_state"));
}
