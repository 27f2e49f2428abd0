#include "src/probe/probe_report.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace triax;
using nlohmann::json;

namespace {

study::ProbedState state_at(double p_kPa, double eta, const study::Probing& probing = {},
                          const std::optional<study::TestedState>& test = {}) {
  const auto set = lab::find_material("inl2/S28-general");
  const double p = 1e3 * p_kPa, q = eta * p;
  study::StateToProbe<sim::Axisymmetric> what;
  what.state = set.material.axisymmetric->start(
      sim::components(sim::AxisymmetricStress{p + 2 * q / 3, p - q / 3}), 1.086);
  what.test = test;
  return study::probe_state(set, what, probing);
}

src::ProbeReport report_of(const std::vector<double>& etas, const study::Probing& probing = {}) {
  src::ProbeReport report;
  report.material = lab::find_material("inl2/S28-general");
  report.probing = probing;
  for (const double eta : etas) report.states.push_back(state_at(70, eta, probing));
  report.many = etas.size() > 1;
  return report;
}

study::TestedState tested(double angle) {
  study::TestedState test{.id = 26, .name = "CSU\n26", .at = "collapse"};
  test.state.reading = 812;
  test.state.time_s = 41;
  test.increment = lab::MeasuredIncrement{
      .angle = angle, .angle_error = 0.01, .normalised = -0.02, .normalised_error = 0.03};
  return test;
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

}  // namespace

TEST_CASE("one state is part of the document, several are a list with the same keys") {
  const json one = json::parse(src::probe_json(report_of({0.6})));
  const json two = json::parse(src::probe_json(report_of({0.5, 0.6})));
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
  CHECK(json::parse(src::probe_json(report_of({0.2, 0.3})))["first_unstable_state"].is_null());
}

TEST_CASE("probes tell increments in the units of their keys, and hold together") {
  const json d = json::parse(src::probe_json(report_of({0.6}, {.norm = 2e3, .directions = 12})));
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
  const json d = json::parse(
      src::probe_json(report_of({0.6}, {.kind = sim::ProbeKind::strain, .norm = 1e-5})));
  CHECK(d["probing"]["kind"] == "strain");
  CHECK(d["probing"]["norm_kPa"].is_null());
  CHECK(d["probing"]["norm_strain"] == 1e-5);
}

TEST_CASE("a test's own increment: inside the cone, outside it, and beside no cone") {
  const auto with = [](double eta, double angle_deg) {
    auto report = report_of({});
    report.states = {state_at(70, eta, {}, tested(sim::radians(angle_deg)))};
    return report;
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
  auto report = report_of({0.6}, {.directions = 12});
  sim::Circle& circle = report.states[0].circle;
  circle.probes.resize(2);
  circle.probes[1] = sim::Probe{.angle = 0.5};
  circle.least = {};
  circle.cones.clear();
  circle.unanswered = 1;
  const json d = json::parse(src::probe_json(report));
  CHECK(d["probes"][1]["answered"] == false);
  for (const char* key : {"w2_normalised", "w2_Pa", "stress", "strain"})
    CHECK(d["probes"][1][key].is_null());
  CHECK(d["least"]["alpha_deg"].is_null());
  CHECK(src::probe_text(report, {}).find("of 12 directions 1 beyond the law's limit") !=
        std::string::npos);
  CHECK(src::probe_text(report, {}).find("unknown") != std::string::npos);
  circle.refused = 1;
  report.states[0].refusal = "its own words";
  CHECK(src::probe_text(report, {}).find("of 12 directions 1 refused by the law: its own words") !=
        std::string::npos);
  CHECK(json::parse(src::probe_json(report))["refusal"] == "its own words");
  CHECK(json::parse(src::probe_json(report))["refused_directions"] == 1);
}

TEST_CASE("the text has the probes only where they are asked for") {
  const auto report = report_of({0.6});
  CHECK(lines(src::probe_text(report, {.probes = true})) >
        lines(src::probe_text(report, {})) + report.states[0].circle.probes.size());
}

TEST_CASE("of many states outside the range the first is named, and how many there are") {
  auto report = report_of({0.1});
  for (const double p_kPa : {5.0, 4.0, 3.0}) report.states.push_back(state_at(p_kPa, 0.1));
  report.many = true;
  const std::string text = src::probe_text(report, {});
  CHECK(text.find("p' is 5 kPa, outside the range 10 to 1000 kPa of inl2/S28-general, and so at 2 "
                  "more of the states") != std::string::npos);
  CHECK(text.find("p' is 4 kPa") == std::string::npos);
}

TEST_CASE("a warning of path and state alike is told once, and so is the head") {
  auto report = report_of({0.6});
  report.warnings = report.states[0].warnings = {"a state of its own kind"};
  const std::string text = src::probe_text(report, {});
  for (const std::string once : {"a state of its own kind", "Second-order work in every"}) {
    const auto at = text.find(once);
    REQUIRE(at != std::string::npos);
    CHECK(text.find(once, at + 1) == std::string::npos);
  }
}

TEST_CASE("cones in words") {
  CHECK(src::cones_in_words(std::vector<sim::Cone>{}) == "none");
  const sim::Cone cone{sim::radians(10), sim::radians(20.126), {}};
  CHECK(src::cones_in_words(std::vector{cone, cone}) == "10.00–20.13, 10.00–20.13");
}

TEST_CASE("without a cone the words say how many directions were answered") {
  sim::Circle circle;
  circle.least.answered = true;
  CHECK(src::cones_in_words(circle, 36) == "none");
  circle.unanswered = 6;
  CHECK(src::cones_in_words(circle, 36) == "none found in 30 directions with a result");
  circle.unanswered = 36;
  circle.least.answered = false;
  CHECK(src::cones_in_words(circle, 36) == "unknown");
}

TEST_CASE("the first unstable state of a list is that of least |eta|, in whatever order") {
  const auto report = report_of({0.8, 0.6, 0.3, 0.7});
  const auto first = report.first_unstable();
  REQUIRE(first);
  CHECK(first->eta() == Approx(0.6));
  CHECK(src::probe_text(report, {}).find("unstable state of these by |η|: p′ 70.00 kPa, q 42.00") !=
        std::string::npos);
  auto tests = report;
  for (auto& state : tests.states) state.test = tested(3.7);
  CHECK_FALSE(tests.first_unstable());
  CHECK(src::probe_text(tests, {}).find("unstable state") == std::string::npos);
  CHECK_FALSE(json::parse(src::probe_json(tests)).contains("first_unstable_state"));
}

TEST_CASE("control is marked as that of the rate where increments are integrated") {
  const auto finite = report_of({0.6}, {.norm = 100, .directions = 12, .finite = true});
  CHECK(src::probe_text(finite, {}).find("by the rate, of dε₁ + 2R dε₃") != std::string::npos);
  CHECK(src::probe_text(finite, {}).find("by the rate, R ") != std::string::npos);
  const json d = json::parse(src::probe_json(finite));
  CHECK(d["control"]["by"] == "rate");
  CHECK(d["isotropic_unloading"]["by"] == "integrated increment");
  const auto strain = report_of({0.6}, {.kind = sim::ProbeKind::strain, .norm = 1e-5});
  CHECK(src::probe_text(strain, {}).find("unloading, a stress increment by the rate") !=
        std::string::npos);
}

TEST_CASE("the matrix of Eq. (32) of every R, with its determinant and the failure rule") {
  const json d = json::parse(src::probe_json(report_of({0.65})));
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
  src::ProbeReport report;
  report.material = lab::find_material("octolinear/S28-general");
  study::StateToProbe<sim::Axisymmetric> what;
  what.state = report.material.material.axisymmetric->start(
      sim::components(sim::AxisymmetricStress{98e3, 56e3}), 1.086);
  report.states = {study::probe_state(report.material, what, report.probing)};
  const json d = json::parse(src::probe_json(report));
  REQUIRE(d["cones_closed_form"].size() == 1);
  for (const char* edge : {"from_deg", "to_deg"})
    CHECK(d["cones_closed_form"][0][edge].get<double>() ==
          Approx(d["cones"][0][edge].get<double>()).epsilon(1e-9));
  CHECK(src::probe_text(report, {}).find("closed form") != std::string::npos);
  CHECK(json::parse(src::probe_json(report_of({0.6})))["cones_closed_form"].is_null());
}
