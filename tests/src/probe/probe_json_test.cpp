// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe_json.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "src/probe/probe_text.hpp"
#include "tests/src/sample_probes.hpp"

using namespace triax;
using nlohmann::json;

TEST_CASE("one state is part of the document, several are a list with the same keys") {
  const json one = json::parse(src::probe_json(src::test::inl2_probes({0.6})));
  const json two = json::parse(src::probe_json(src::test::inl2_probes({0.5, 0.6})));
  CHECK(one["origin"] == "simulated");
  CHECK(one["material"]["law"] == "inl2");
  CHECK(one["cones"].size() == 1);
  CHECK_FALSE(one.contains("states"));
  CHECK_FALSE(two.contains("cones"));
  REQUIRE(two["states"].size() == 2);
  const json& first = two["first_unstable_state"];
  CHECK(first["eta"].get<double>() == Approx(0.6));
  CHECK(first["p_eff_kPa"].get<double>() == Approx(70));
  CHECK(first["alpha_deg"] == one["least"]["alpha_deg"]);
  CHECK(first["axial_strain"].is_null());
  for (const char* key : {"state", "cones", "least", "isotropic_unloading", "own_increment",
                          "unanswered_directions", "probes"}) {
    INFO(key);
    CHECK(two["states"][1][key] == one[key]);
  }
  CHECK(two["states"][0]["cones"].empty());
  CHECK(json::parse(src::probe_json(src::test::inl2_probes({0.2, 0.3})))["first_unstable_state"]
            .is_null());
}

TEST_CASE("probes tell increments in the units of their keys, and hold together") {
  const json d =
      json::parse(src::probe_json(src::test::inl2_probes({0.6}, {.norm = 2e3, .directions = 12})));
  CHECK(d["probing"]["norm_kPa"] == 2.0);
  CHECK(d["probing"]["norm_strain"].is_null());
  CHECK(d["probing"]["step_deg"] == 30.0);
  CHECK(d["probes"].size() >= 12);
  for (const auto& probe : d["probes"]) {
    const double s1 = probe["stress"]["axial_kPa"], s3 = probe["stress"]["radial_kPa"];
    const double e1 = probe["strain"]["axial"], e3 = probe["strain"]["radial"];
    CHECK(std::hypot(s1, std::sqrt(2) * s3) == Approx(2));
    CHECK(probe["w2_Pa"].get<double>() == Approx(1e3 * (s1 * e1 + 2 * s3 * e3)).margin(1e-12));
    const double alpha = sim::radians(probe["alpha_deg"].get<double>());
    CHECK(s1 == Approx(2 * std::sin(alpha)).margin(1e-12));
  }
  const auto& cone = d["cones"][0];
  CHECK(cone["opening_deg"].get<double>() ==
        Approx(cone["to_deg"].get<double>() - cone["from_deg"].get<double>()));
  CHECK(cone["w2_normalised_least"] == d["least"]["w2_normalised"]);
  CHECK(d["isotropic_unloading"]["in_cone"] == true);
  CHECK(d["state"]["radial_stress_kPa"].get<double>() == Approx(56));
  CHECK(d["state"]["memory_from"] == "start");
}

TEST_CASE("strain probes give their norm as a strain") {
  const json d = json::parse(src::probe_json(
      src::test::inl2_probes({0.6}, {.kind = sim::ProbeKind::strain, .norm = 1e-5})));
  CHECK(d["probing"]["kind"] == "strain");
  CHECK(d["probing"]["norm_kPa"].is_null());
  CHECK(d["probing"]["norm_strain"] == 1e-5);
}

TEST_CASE("a test's own increment: inside the cone, outside it, and beside no cone") {
  const auto with = [](double eta, double angle_deg) {
    study::ProbeResult result;
    result.material = lab::find_material("inl2/S28-general");
    result.states = {src::test::inl2_tested(eta, src::test::tested(sim::radians(angle_deg)))};
    return result;
  };
  const auto own = [&](double eta, double angle_deg) {
    return json::parse(src::probe_json(with(eta, angle_deg)))["own_increment"];
  };
  const json inside = own(0.6, 216), outside = own(0.6, 213), alone = own(0.3, 216);
  CHECK(inside["in_cone"] == true);
  CHECK(inside["cone"] == 0);
  CHECK(inside["alpha_deg"].get<double>() == Approx(216));
  CHECK(inside["nearest_edge_deg"].get<double>() == Approx(216 - 214.835).margin(1e-2));
  CHECK(inside["w2_normalised_measured"] == -0.02);
  CHECK(inside["w2_normalised_law"].get<double>() < 0);
  CHECK(outside["in_cone"] == false);
  CHECK(outside["nearest_edge_deg"].get<double>() == Approx(214.835 - 213).margin(1e-2));
  CHECK(alone["in_cone"] == false);
  CHECK(alone["cone"].is_null());
  CHECK(alone["nearest_edge_deg"].is_null());

  const std::string text = src::probe_text(with(0.6, 216), {});
  CHECK(text.find("inside the cone 214.83–237.59, 1.2° from the nearest edge") !=
        std::string::npos);
  CHECK(inside["certain"] == true);
  // 0.5 degrees from the edge, with a standard error of 0.57.
  CHECK(own(0.6, 215.3)["in_cone"] == true);
  CHECK(own(0.6, 215.3)["certain"] == false);
  CHECK(src::probe_text(with(0.6, 215.3), {})
            .find("on the edge of the cone 214.83–237.59 within its error, 0.5° inside") !=
        std::string::npos);
  CHECK(text.find("CSU 26 (number 26, recorded) at collapse, reading 812, 41.0 s") !=
        std::string::npos);
  CHECK(src::probe_text(with(0.6, 213), {}).find("1.8° from the nearest edge") !=
        std::string::npos);
}

TEST_CASE("directions without an answer are null and empty, and told") {
  auto result = src::test::inl2_probes({0.6}, {.directions = 12});
  sim::Circle& circle = result.states[0].circle;
  circle.probes.resize(2);
  circle.probes[1] = sim::Probe{.angle = 0.5};
  circle.least = {};
  circle.cones.clear();
  circle.unanswered = 1;
  const json d = json::parse(src::probe_json(result));
  CHECK(d["probes"][1]["answered"] == false);
  for (const char* key : {"w2_normalised", "w2_Pa", "stress", "strain"})
    CHECK(d["probes"][1][key].is_null());
  CHECK(d["least"]["alpha_deg"].is_null());
  CHECK(src::probe_text(result, {}).find("of 12 directions 1 beyond the law's limit") !=
        std::string::npos);
  CHECK(src::probe_text(result, {}).find("unknown") != std::string::npos);
  circle.refused = 1;
  result.states[0].refusal = "its own words";
  CHECK(src::probe_text(result, {}).find("of 12 directions 1 rejected by the law: its own words") !=
        std::string::npos);
  CHECK(json::parse(src::probe_json(result))["refusal"] == "its own words");
  CHECK(json::parse(src::probe_json(result))["refused_directions"] == 1);
}

TEST_CASE("control is marked as that of the rate where increments are integrated") {
  const auto finite =
      src::test::inl2_probes({0.6}, {.norm = 100, .directions = 12, .finite = true});
  CHECK(src::probe_text(finite, {}).find("by the rate, of dε₁ + 2R dε₃") != std::string::npos);
  CHECK(src::probe_text(finite, {}).find("by the rate, R ") != std::string::npos);
  const json d = json::parse(src::probe_json(finite));
  CHECK(d["control"]["by"] == "rate");
  CHECK(d["isotropic_unloading"]["by"] == "integrated increment");
  const auto strain = src::test::inl2_probes({0.6}, {.kind = sim::ProbeKind::strain, .norm = 1e-5});
  CHECK(src::probe_text(strain, {}).find("unloading, a stress increment by the rate") !=
        std::string::npos);
}

TEST_CASE("the matrix of Eq. (32) of every R, with its determinant and the failure rule") {
  const json d = json::parse(src::probe_json(src::test::inl2_probes({0.65})));
  for (const auto& at : d["control"]["scan"]) {
    const auto& m = at["matrix"];
    REQUIRE(m.is_object());
    const double a = m["stress_by_axial_strain_kPa"], b = m["stress_by_radial_stress_over_R"],
                 c = m["strain_by_axial_strain"], e = m["strain_by_radial_stress_over_R_per_kPa"];
    const double determinant = m["determinant"];
    CHECK(a * e - b * c == Approx(determinant).margin(1e-9));
    CHECK((determinant < 0) == (at["mode_w2_normalised"].get<double>() < 0));
    CHECK(at["loading"]["index"].is_null() == (at["loading"]["control"] == "lost"));
  }
}

TEST_CASE("an octolinear law has its cones in closed form beside the probed ones") {
  study::ProbeResult result;
  result.material = lab::find_material("octolinear/S28-general");
  study::StateToProbe<sim::Axisymmetric> what;
  what.state = result.material.material.axisymmetric->start(
      sim::components(sim::AxisymmetricStress{98e3, 56e3}), 1.086);
  result.states = {study::probe_state(result.material, what, result.probing)};
  const json d = json::parse(src::probe_json(result));
  REQUIRE(d["cones_closed_form"].size() == 1);
  for (const char* edge : {"from_deg", "to_deg"})
    CHECK(d["cones_closed_form"][0][edge].get<double>() ==
          Approx(d["cones"][0][edge].get<double>()).epsilon(1e-9));
  CHECK(src::probe_text(result, {}).find("closed form") != std::string::npos);
  CHECK(json::parse(src::probe_json(src::test::inl2_probes({0.6})))["cones_closed_form"].is_null());
}
