// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/state_json.hpp"

#include <catch2/catch.hpp>

using namespace triax;

TEST_CASE("a state tells stresses in kPa, its memory by name, and what it does not know as null") {
  study::StateHead state;
  state.stress << 120e3, 90e3, 90e3;
  state.p = 100e3;
  state.q = 30e3;
  state.void_ratio = 1.05;
  state.memory = {{"alpha", 0.25}};
  const auto d = src::state_json(state);
  CHECK(d["p_eff_kPa"] == 100.0);
  CHECK(d["q_kPa"] == 30.0);
  CHECK(d["eta"] == 0.3);
  CHECK(d["axial_stress_kPa"] == 120.0);
  CHECK(d["radial_stress_kPa"] == 90.0);
  CHECK(d["memory"]["alpha"] == 0.25);
  CHECK(d["memory_from"] == "start");
  for (const char* key : {"name", "axial_strain", "test"}) CHECK(d[key].is_null());
  state.stress(1) = 100e3;
  CHECK(src::state_json(state)["radial_stress_kPa"].is_null());
  CHECK(src::state_json(state)["principal_stresses_kPa"][1] == 100.0);
}

TEST_CASE("a measured state names its test and reading") {
  study::StateHead state;
  state.test = study::TestedState{.id = 26, .name = "CSU 26", .at = "peak", .has_time = false};
  state.test->state.reading = 812;
  state.test->state.time_s = 41;
  const auto test = src::state_json(state)["test"];
  CHECK(test["id"] == 26);
  CHECK(test["reading"] == 812);
  CHECK(test["origin"] == "recorded");
  CHECK(test["time_s"].is_null());
  CHECK(test["axial_strain"].is_null());
}
