// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/run_probe.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/paths/path_reader.hpp"
#include "tests/lab/paths/path_text.hpp"
#include "tests/src/sample_probes.hpp"

using namespace triax;
using src::test::inl2_probes;
using src::test::inl2_request;

TEST_CASE("a study of probes has a state for each that is asked for, and tells how far it is") {
  std::vector<double> shares;
  const auto result =
      study::run_probe(inl2_request({0.5, 0.6}), [&](const std::string& what, double share) {
        CHECK(what == "probes");
        shares.push_back(share);
      });
  CHECK(shares == std::vector<double>{0.5, 1});
  REQUIRE(result.states.size() == 2);
  CHECK(result.many);
  CHECK(result.any_answer());
  CHECK(result.states[1].eta() == Approx(0.6));
  CHECK(result.states[0].circle.cones.empty());
  CHECK(result.states[1].circle.cones.size() == 1);
  CHECK(result.figures.circles.empty());
  CHECK_THROWS_WITH(study::run_probe(inl2_request({1.5})), Catch::Contains("out of range for"));
}

TEST_CASE("the first unstable state of a list is that of least |eta|, of tests there is none") {
  auto result = inl2_probes({0.8, 0.6, 0.3, 0.7});
  REQUIRE(result.first_unstable());
  CHECK(result.first_unstable()->eta() == Approx(0.6));
  result.states[0].test = study::TestedState{};
  CHECK_FALSE(result.has_first());
  CHECK_FALSE(result.first_unstable());
}

TEST_CASE("along a path the first unstable state lies between its rows") {
  auto path = lab::read_path(
      lab::test::with(lab::test::with(lab::test::kPath, "1.0", "1.086"), "sanisand", "inl2"),
      "p.toml");
  study::ProbeRequest request{.material = path.material,
                              .states = study::StatesOfPath{path, 3},
                              .probing = {.directions = 12}};
  const auto result = study::run_probe(request);
  CHECK(result.path == path.name);
  REQUIRE(result.isolated);
  bool is_row = false;
  for (const auto& state : result.states)
    is_row = is_row || state.axial_strain == result.isolated->axial_strain;
  CHECK_FALSE(is_row);
  CHECK(result.first_unstable()->axial_strain == result.isolated->axial_strain);
}

TEST_CASE("of many states a few are drawn, coarse circles every degree") {
  std::vector<double> etas;
  for (int i = 0; i < 20; ++i) etas.push_back(0.03 * i);
  const auto result = study::run_probe(inl2_request(etas, {}, true));
  std::vector<std::size_t> drawn;
  for (const auto& one : result.figures.circles) {
    drawn.push_back(one.state);
    CHECK(one.circle.probes.size() >= 360);
  }
  CHECK(drawn == std::vector<std::size_t>{0, 4, 9, 14, 19});
  CHECK(result.figures.directions == 360);
  CHECK(result.states[0].circle.probes.size() < 60);
  CHECK(result.figures.cones.states.size() == 20);
  CHECK(result.figures.cones.limit_stress_ratio);

  const auto fine = study::run_probe(inl2_request({0.6}, {.directions = 200}, true));
  CHECK(fine.figures.directions == 200);
  CHECK(fine.figures.circles.at(0).circle.probes.size() == fine.states[0].circle.probes.size());
}

TEST_CASE("cones that would lie on each other are shown once; those of strain probes not at all") {
  const auto close = study::run_probe(inl2_request({0.6, 0.601, 0.7}, {}, true));
  REQUIRE(close.figures.cones.states.size() == 2);
  CHECK(close.figures.cones.states[1].state.q == Approx(49e3));
  REQUIRE(close.figures.cones.states[0].cones.size() == 1);
  CHECK(close.figures.cones.states[0].cones[0].from == close.states[0].circle.cones[0].from);
  const auto strain =
      study::run_probe(inl2_request({0.6}, {.kind = sim::ProbeKind::strain, .norm = 1e-5}, true));
  CHECK(strain.figures.cones.states.empty());
  CHECK(strain.figures.circles.size() == 1);
}
