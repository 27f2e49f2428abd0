// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/json_report.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/src/sample_tests.hpp"

using namespace triax::src;
using namespace triax::study;
using nlohmann::json;

TEST_CASE("one test is one object with the contract's keys and the sample's numbers") {
  const json d = json::parse(json_report({test::flow_test()}));
  CHECK(d["test"]["id"] == 3);
  CHECK(d["test"]["name"] == "L<oose> 1");
  CHECK(d["test"]["origin"] == "recorded");
  CHECK(d["test"]["digest"].is_null());
  CHECK(d["test"]["tags"].empty());
  CHECK(d["specimen"]["height_mm"].get<double>() == Approx(140));
  CHECK(d["consolidation"]["p_eff_kPa"].get<double>() == Approx(140));
  CHECK(d["consolidation"]["b_value"].get<double>() == Approx(0.97));
  CHECK(d["peak"]["q_kPa"].get<double>() == Approx(60));
  const json& c = d["collapse"];
  CHECK(c["detected"] == true);
  CHECK(c["kind"] == "flow");
  CHECK(c["inside_limit_surface"] == true);
  CHECK(c["reading"] == 300);
  CHECK(c["time_s"].get<double>() == Approx(30));
  CHECK(c["eta"].get<double>() == Approx(0.6));
  CHECK(c["phi_mob_deg"].get<double>() == Approx(15.827).epsilon(1e-3));
  CHECK(c["pore_pressure_kPa"].get<double>() == Approx(360));
  CHECK(c["second_order_work_normalised"].get<double>() == Approx(-0.02));
  REQUIRE(c["criteria"].size() == 3);
  CHECK(c["criteria"][0]["name"] == "second_order_work");
  CHECK(c["criteria"][2]["detected"] == false);
  CHECK(c["criteria"][2]["reading"].is_null());
  CHECK(c["truth"].is_null());
  CHECK(d["checks"][1]["measured"].is_null());
  CHECK(d["warnings"].size() == 2);  // the one that stands twice once
}

TEST_CASE("in short it is the same objects, with digest and tags") {
  auto test = test::flow_test();
  test.stored.header.digest = "ab12";
  test.stored.tags = {"loose", "thesis"};
  const json d = json::parse(json_report({test})), brief = json::parse(json_in_short(test.stored));
  CHECK(d["test"]["digest"] == "ab12");
  CHECK(d["test"]["tags"] == json::array({"loose", "thesis"}));
  for (const char* part : {"test", "specimen", "collapse", "warnings"})
    CHECK(brief[part] == d[part]);
  CHECK(brief.size() == 4);
}

TEST_CASE("what is unknown is null, and what has no verdict has none") {
  const json stable = json::parse(json_report({test::stable_test()}));
  CHECK(stable["collapse"]["detected"] == false);
  CHECK(stable["collapse"]["eta"].is_null());
  CHECK(stable["specimen"]["height_mm"].is_null());
  CHECK(stable["peak"]["time_s"].is_null());
  const json cut = json::parse(json_report({test::interrupted_test()}));
  CHECK(cut["collapse"]["detected"].is_null());
  CHECK(cut["collapse"]["kind"].is_null());
  auto blind = test::stable_test();
  blind.stored.summary.collapse.judged = false;
  CHECK(json::parse(json_report({blind}))["collapse"]["kind"].is_null());
}

TEST_CASE("no number that JSON cannot hold gets out") {
  auto odd = test::flow_test();
  odd.stored.summary.peak->q_pa = std::numeric_limits<double>::quiet_NaN();
  odd.stored.summary.consolidation.p_eff_pa = std::numeric_limits<double>::infinity();
  const json d = json::parse(json_report({odd}));
  CHECK(d["peak"]["q_kPa"].is_null());
  CHECK(d["consolidation"]["p_eff_kPa"].is_null());
}

TEST_CASE("several tests are an array, the truth belongs to simulations") {
  const json all = json::parse(json_report({test::flow_test(), test::simulated_test()}));
  REQUIRE(all.is_array());
  REQUIRE(all.size() == 2);
  CHECK(all[1]["test"]["origin"] == "simulated");
  CHECK(all[1]["collapse"]["truth"]["time_s"].get<double>() == Approx(29.95));
}

TEST_CASE("beside the fitted onset stands its reading; cycles of load where there were any") {
  auto test = test::flow_test();
  CHECK(json::parse(json_report({test}))["collapse"]["reading_itself"].is_null());
  CHECK(json::parse(json_report({test}))["cyclic"].is_null());
  auto& state = test.stored.state_at_onset.emplace();
  state.reading = 300;
  state.q = 61e3;
  state.p_eff = 99e3;
  test.stored.summary.cyclic = triax::lab::CyclicLoading{.cycles = 3.5, .stress_ratio = 0.2};
  test.stored.summary.cyclic->double_amplitude.emplace().instant.reading = 290;
  const json d = json::parse(json_report({test}));
  CHECK(d["collapse"]["reading_itself"]["reading"] == 300);
  CHECK(d["collapse"]["reading_itself"]["q_kPa"].get<double>() == Approx(61));
  CHECK(d["collapse"]["q_kPa"].get<double>() == Approx(60));
  CHECK(d["cyclic"]["cycles"].get<double>() == Approx(3.5));
  CHECK(d["cyclic"]["cyclic_stress_ratio"].get<double>() == Approx(0.2));
  CHECK(d["cyclic"]["double_amplitude_5_pct"]["reading"] == 290);
  CHECK(d["cyclic"]["liquefied"].is_null());
}

TEST_CASE("json_report: loss of control beside the onset, null without one", "[report]") {
  auto test = test::flow_test();
  const json none = json::parse(json_report({test}))["collapse"];
  REQUIRE(none.contains("loss_of_control"));
  CHECK(none["loss_of_control"].is_null());
  CHECK(none["total_interval"].is_null());
  CHECK(none["uncertainty_budget"].is_null());
  CHECK(json::parse(json_of_instants(test.stored))["loss_of_control"].is_null());

  auto& collapse = test.stored.summary.collapse;
  collapse.loss_of_control = triax::lab::Instant{340, 34.0, 0.006, 50e3, 80e3, 380e3};
  collapse.loss_of_control->interval = {{49e3, 51e3}, {78e3, 82e3}, {0.6, 0.65}};
  collapse.loss_of_control_detected_at = triax::lab::Moment{342, 34.2};
  collapse.onset->total = {.interval = {{55e3, 65e3}, {90e3, 110e3}, {0.5, 0.7}},
                           .budget = {{"gain of the load cell", 0.6}}};
  const json c = json::parse(json_report({test}))["collapse"];
  const json& lost = c["loss_of_control"];
  CHECK(lost["reading"] == 340);
  CHECK(lost["time_s"] == 34.0);
  CHECK(lost["axial_strain"] == 0.006);
  CHECK(lost["q_kPa"].get<double>() == Approx(50));
  CHECK(lost["pore_pressure_kPa"].get<double>() == Approx(380));
  CHECK(lost["eta"].get<double>() == Approx(0.625));
  CHECK(lost["eta_low"] == 0.6);
  CHECK(lost["detected_at"]["reading"] == 342);
  CHECK(c["total_interval"]["eta_high"] == 0.7);
  CHECK(c["total_interval"]["q_low_kPa"].get<double>() == Approx(55));
  CHECK(c["uncertainty_budget"][0]["name"] == "gain of the load cell");
  CHECK(c["uncertainty_budget"][0]["share"] == 0.6);
  const json both = json::parse(json_of_instants(test.stored));
  CHECK(both["loss_of_control"] == lost);
  CHECK(both["onset"]["reading"] == c["reading"]);
  CHECK(both["onset"]["total_interval"]["eta_low"] == 0.5);
}

TEST_CASE("json_report: the truth has both instants", "[report]") {
  auto test = test::simulated_test();
  const auto truth = [&] {
    return json::parse(json_report({test}))["collapse"]["truth"]["loss_of_control"];
  };
  CHECK(truth().is_null());
  auto& run_aways = test.stored.summary.truth->run_aways;
  run_aways = {{.start_s = 29.95}};  // that of the onset
  CHECK(truth()["time_s"] == 29.95);
  CHECK(truth()["q_kPa"].get<double>() == Approx(60));
  run_aways = {{.start_s = 40}};
  CHECK(truth()["time_s"] == 40.0);
  CHECK(truth()["q_kPa"].is_null());
  run_aways[0].q_pa = 55e3;
  run_aways[0].p_eff_pa = 50e3;
  CHECK(truth()["eta"].get<double>() == Approx(1.1));
}

TEST_CASE("events say of which reading they speak and at which they were known") {
  auto test = test::flow_test();
  CHECK(json::parse(json_report({test}))["events"].empty());
  using enum triax::lab::EventKind;
  test.stored.events = {{300, 30.0, loss_of_sustainability, "fell", triax::lab::Moment{330, 33.0}},
                        {310, {}, limit_surface, "late", {}}};
  const json events = json::parse(json_report({test}))["events"];
  REQUIRE(events.size() == 2);
  CHECK(events[0]["kind"] == "loss_of_sustainability");
  CHECK(events[0]["reading"] == 300);
  CHECK(events[0]["time_s"] == 30.0);
  CHECK(events[0]["detected_at_reading"] == 330);
  CHECK(events[0]["detected_at_time_s"] == 33.0);
  CHECK(events[0]["detail"] == "fell");
  CHECK(events[1]["detected_at_reading"].is_null());
  CHECK(events[1]["detected_at_time_s"].is_null());
}

TEST_CASE("the interval of the onset and when it was known are told, and null where unknown") {
  auto test = test::flow_test();
  auto& collapse = test.stored.summary.collapse;
  const json none = json::parse(json_report({test}))["collapse"];
  for (const char* key : {"eta_low", "eta_high", "q_low_kPa", "q_high_kPa", "p_eff_low_kPa",
                          "p_eff_high_kPa", "detected_at"}) {
    INFO(key);
    REQUIRE(none.contains(key));
    CHECK(none[key].is_null());
  }
  CHECK(none["criteria"][0]["detected_at_reading"].is_null());
  CHECK(none["criteria"][0]["detected_at_time_s"].is_null());

  collapse.onset->interval = {{58e3, 61e3}, {96e3, 104e3}, {0.57, 0.62}};
  collapse.onset_detected_at = triax::lab::Moment{330, 33.0};
  collapse.criteria[0].detected_at = triax::lab::Moment{340, std::nullopt};
  const json c = json::parse(json_report({test}))["collapse"];
  CHECK(c["eta_low"] == 0.57);
  CHECK(c["eta_high"] == 0.62);
  CHECK(c["q_low_kPa"].get<double>() == Approx(58));
  CHECK(c["q_high_kPa"].get<double>() == Approx(61));
  CHECK(c["p_eff_low_kPa"].get<double>() == Approx(96));
  CHECK(c["p_eff_high_kPa"].get<double>() == Approx(104));
  CHECK(c["detected_at"]["reading"] == 330);
  CHECK(c["detected_at"]["time_s"] == 33.0);
  CHECK(c["criteria"][0]["detected_at_reading"] == 340);
  CHECK(c["criteria"][0]["detected_at_time_s"].is_null());
}
