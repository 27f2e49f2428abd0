#include "src/triaxial/figures/shear_states.hpp"

#include <catch2/catch.hpp>

#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;

namespace {
double p_kPa(const lab::State& s) { return s.p_eff * 1e-3; }
double q_kPa(const lab::State& s) { return s.q * 1e-3; }
}  // namespace

TEST_CASE("a stage counts as shear where it is said, and where nothing is said of it") {
  lab::RecordHeader header;
  CHECK(is_shear(header, 1));
  header.stages = {{.number = 1, .name = "c", .role = lab::StageRole::consolidation},
                   {.number = 2, .name = "s", .role = lab::StageRole::shear},
                   {.number = 3, .name = "?", .role = lab::StageRole::unknown}};
  CHECK_FALSE(is_shear(header, 1));
  CHECK(is_shear(header, 2));
  CHECK(is_shear(header, 3));
}

TEST_CASE("points of shear leave out other stages and what is not known") {
  auto test = test::flow_test();
  const auto all = test.curves.states.size();
  CHECK(shear_points(test, p_kPa, q_kPa).size() == all);
  test.curves.states[5].q = lab::kMissing;
  test.stored.header.stages.push_back(
      {.number = 2, .name = "c", .role = lab::StageRole::consolidation});
  test.curves.states[7].stage = 2;
  const auto points = shear_points(test, p_kPa, q_kPa);
  CHECK(points.size() == all - 2);
  CHECK(points.front() == QPointF(140, 0));
}

TEST_CASE("points within bounds end at the first that is outside") {
  const auto test = test::flow_test();
  const auto points = shear_points_within(test, p_kPa, q_kPa, 1000, 30);
  REQUIRE(points.size() > 10);
  CHECK(points.size() < 300);
  for (const auto& point : points) CHECK(point.y() <= 30);
}

TEST_CASE("the state at the onset is the nearest that was kept") {
  auto test = test::flow_test();
  CHECK(state_at_onset(test)->reading == 300);
  std::erase_if(test.curves.states, [](const auto& s) { return s.reading % 7 != 0; });
  CHECK(state_at_onset(test)->reading == 301);
  CHECK_FALSE(state_at_onset(test::stable_test()));
}
