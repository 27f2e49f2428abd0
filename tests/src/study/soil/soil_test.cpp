// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/soil.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/base/bad_input.hpp"
#include "lab/base/toml_reader.hpp"
#include "src/study/soil/soil_json.hpp"

using namespace triax;
using study::ShearedTest;

namespace {

constexpr double kM = 1.3, kGamma = 1.0, kLambda = 0.03;

/// Drained, sheared to 25 %: eta runs from 0 to M and e to the line e = Gamma - lambda ln p', both
/// like exp(-eps_a/2 %), so that it is at rest.
ShearedTest drained(std::int64_t id, double p0_kPa, double m = kM, double e_error = 0) {
  ShearedTest test{.id = id, .name = "D" + std::to_string(id)};
  test.drainage = lab::Drainage::open;
  test.p_eff_pa = p0_kPa * 1e3;
  const double p_c = 3 * p0_kPa / (3 - m);
  const double e_c = kGamma - kLambda * std::log(p_c), e0 = e_c + 0.03;
  test.void_ratio = e0 + e_error;
  for (int i = 0; i <= 500; ++i) {
    lab::State s;
    s.reading = i + 1;
    const double strain = 0.25 * i / 500, done = 1 - std::exp(-strain / 0.02);
    const double eta = m * done, p = 3 * p0_kPa * 1e3 / (3 - eta);
    s.volumetric_strain = 0.03 * done / (1 + e0);
    s.strain = {strain, (s.volumetric_strain - strain) / 2};
    s.p_eff = p;
    s.q = eta * p;
    s.void_ratio = e0 - 0.03 * done + e_error;
    test.states.push_back(s);
  }
  return test;
}

/// Undrained: q rises to its peak at 2 % and falls to a third of it, or rises on to 25 %.
ShearedTest undrained(std::int64_t id, double p0_kPa, double e, double q_peak_kPa, bool peak) {
  ShearedTest test{.id = id, .name = "U" + std::to_string(id)};
  test.drainage = lab::Drainage::closed;
  test.p_eff_pa = p0_kPa * 1e3;
  test.void_ratio = e;
  for (int i = 0; i <= 500; ++i) {
    const double strain = 0.25 * i / 500;
    const double share = !peak           ? strain / 0.25
                         : strain < 0.02 ? strain / 0.02
                                         : 1 - (strain - 0.02) / 0.345;
    lab::State s;
    s.reading = i + 1;
    s.strain = {strain, -strain / 2};
    s.volumetric_strain = 0;
    s.q = share * q_peak_kPa * 1e3;
    s.p_eff = p0_kPa * 1e3 * (1 - 2 * strain);
    s.void_ratio = e;
    test.states.push_back(s);
  }
  return test;
}

std::vector<ShearedTest> campaign() {
  std::vector<ShearedTest> tests;
  for (const double p0 : {50.0, 100.0, 200.0, 300.0, 400.0, 800.0})
    tests.push_back(drained(static_cast<std::int64_t>(tests.size()) + 1, p0));
  return tests;
}

}  // namespace

TEST_CASE("Tests at rest give the line and M that they were made of") {
  const auto soil = study::study_soil(campaign(), "sand");
  REQUIRE(soil.critical_line);
  CHECK(soil.critical_line->line.a == Approx(kGamma).epsilon(1e-3));
  CHECK(soil.critical_line->line.b == Approx(-kLambda).epsilon(1e-2));
  REQUIRE(soil.critical_ratio);
  CHECK(soil.critical_ratio->fit.mean.value == Approx(kM).epsilon(1e-3));
  CHECK(to_string(soil.tests[0].critical.kind) == "reached");
  REQUIRE(soil.tests[0].state_parameter);
  CHECK(soil.tests[0].state_parameter->value ==
        Approx(0.03 - kLambda * std::log(3 / (3 - kM))).margin(1e-3));
}

TEST_CASE("A void ratio that is wrong is named, and left out unless it is to stay") {
  auto tests = campaign();
  tests[2] = drained(3, 200, kM, 0.1);
  const auto soil = study::study_soil(tests, "sand");
  CHECK(soil.tests[2].reason.find("e at the critical state is") != std::string::npos);
  CHECK(soil.critical_line->line.tests == 5);
  CHECK(soil.critical_line->line.b == Approx(-kLambda).epsilon(1e-2));
  const auto kept = study::study_soil(tests, "sand", {.keep_odd = true});
  CHECK(kept.critical_line->line.tests == 6);
  CHECK_FALSE(kept.tests[2].reason.empty());
}

TEST_CASE("A load cell that reads too much is named for M") {
  auto tests = campaign();
  tests[4] = drained(5, 400, 1.5);
  const auto soil = study::study_soil(tests, "sand");
  CHECK(soil.tests[4].reason.find("M in compression") != std::string::npos);
  CHECK(soil.critical_ratio->fit.mean.value == Approx(kM).epsilon(1e-3));
}

// Peaks of q/(2 p0) = 0.3 - 2 psi, and one test whose q rises to its end at half again as much.
TEST_CASE("Undrained strength over psi is that of tests that passed a peak of q") {
  auto tests = campaign();
  const auto line = study::study_soil(tests, "sand").critical_line->line;
  const auto with_psi = [&](double psi, double ratio, bool peak) {
    const double e = line.a + line.b * std::log(100.0) + psi;
    tests.push_back(
        undrained(static_cast<std::int64_t>(tests.size()) + 1, 100, e, 200 * ratio, peak));
  };
  for (const double psi : {0.02, 0.04, 0.06, 0.08, 0.10}) with_psi(psi, 0.3 - 2 * psi, true);
  with_psi(0.03, 0.45, false);
  const auto soil = study::study_soil(tests, "sand");
  REQUIRE(soil.strength_over_state);
  CHECK(soil.strength_over_state->line.tests == 5);
  CHECK(soil.strength_over_state->line.b == Approx(-2).epsilon(0.02));
  CHECK(soil.tests.back().reason.empty());
  CHECK(soil.tests.back().strength_ratio == Approx(0.45).epsilon(0.01));
}

// The loosest of a row: beyond what the others tell of a curve, whose usual size is known.
TEST_CASE("A wrong void ratio is named where its test is the last of a row") {
  auto tests = campaign();
  const auto line = study::study_soil(tests, "sand").critical_line->line;
  for (const double psi : {0.02, 0.04, 0.06, 0.08, 0.10, 0.20}) {
    const double e = line.a + line.b * std::log(100.0) + psi, true_psi = psi > 0.1 ? 0.05 : psi;
    tests.push_back(undrained(static_cast<std::int64_t>(tests.size()) + 1, 100, e,
                              200 * (0.3 - 2 * true_psi), true));
  }
  const auto soil = study::study_soil(tests, "sand");
  CHECK(soil.tests.back().reason.find("undrained strength over ψ") != std::string::npos);
  for (std::size_t i = 0; i + 1 < soil.tests.size(); ++i) CHECK(soil.tests[i].reason.empty());
}

TEST_CASE("The same test twice counts once, whatever it is called") {
  auto tests = campaign();
  tests.push_back(tests[1]);
  tests.back().id = 7;
  tests.back().name = "again";
  const auto soil = study::study_soil(tests, "sand");
  CHECK_FALSE(soil.tests[1].used);
  CHECK(soil.tests[1].reason == "the same test as 7 (again), which replaces it");
  CHECK(soil.critical_ratio->fit.mean.tests == 6);
}

TEST_CASE("Values that are not known do not make a test another one") {
  auto tests = campaign();
  tests[1].states[3].p_eff = lab::kMissing;
  tests.push_back(tests[1]);
  tests.back().id = 7;
  tests.back().name = "again";
  CHECK_FALSE(study::study_soil(tests, "sand").tests[1].used);
  tests.back().states[3].p_eff = 1e5;
  CHECK(study::study_soil(tests, "sand").tests[1].used);
}

TEST_CASE("Tests without void ratio are told and count for M") {
  auto tests = campaign();
  for (auto& test : tests) {
    test.void_ratio.reset();
    for (auto& s : test.states) s.void_ratio = lab::kMissing;
  }
  const auto soil = study::study_soil(tests, "sand");
  CHECK_FALSE(soil.critical_line);
  CHECK(soil.critical_ratio->fit.mean.value == Approx(kM).epsilon(1e-3));
  CHECK(soil.notes.front().starts_with("the void ratio of D1, D2"));
}

TEST_CASE("No test with a shear is bad input") {
  CHECK_THROWS_AS(study::study_soil({ShearedTest{}}, "sand"), lab::BadInput);
}

TEST_CASE("The TOML reads back with the values of the JSON") {
  const auto soil = study::study_soil(campaign(), "a \"sand\"");
  const auto json = study::soil_json(soil);
  const auto toml = lab::TomlTable::parse(study::toml_document(json), "soil.toml");
  CHECK(toml.required_text("kind") == "soil");
  CHECK(toml.required_text("group") == "a \"sand\"");
  CHECK(toml.required_table("friction")
            .required_table("critical_stress_ratio")
            .required_number("value") ==
        json["friction"]["critical_stress_ratio"]["value"].get<double>());
  CHECK(toml.tables("tests").size() == 6);
  CHECK(toml.required_table("critical_state_line")
            .required_table("log_linear")
            .required_table("lambda")
            .required_number("value") == Approx(kLambda).epsilon(1e-2));
}
