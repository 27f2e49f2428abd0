// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/calibration.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "bench/calibrate/virtual_tests.hpp"
#include "lab/base/bad_input.hpp"
#include "src/study/calibrate/calibrated_set.hpp"
#include "src/study/calibrate/calibration_json.hpp"
#include "src/study/calibrate/calibration_piece.hpp"
#include "src/study/calibrate/test_paths.hpp"

using namespace triax;
using namespace triax::study;
using Catch::Contains;

namespace {

/// Free parameters away from the start, as tests of a soil that is not the start's.
struct Case {
  std::string start;
  std::vector<std::pair<std::string, double>> truth;
  std::vector<bench::VirtualTest> tests;
};

lab::MaterialSet with(lab::MaterialSet set, const Case& c) {
  for (const auto& [key, value] : c.truth) set.parameters.numbers[key] = value;
  set.material = set.law->make(set.parameters, {});
  return set;
}

CalibrationRequest request_of(const Case& c, const bench::InstrumentNoise& noise = {},
                              unsigned seed = 1) {
  const auto start = lab::find_material(c.start);
  const auto truth = with(start, c);
  CalibrationRequest request{.start = start, .searches = 1, .seed = seed, .threads = 2};
  for (const auto& range : lab::shipped_search(start.law->name))
    for (const auto& [key, value] : c.truth)
      if (key == range.key) request.free.push_back(range);
  std::mt19937_64 dice(seed);
  for (const auto& test : c.tests)
    request.paths.push_back(bench::virtual_path(truth, test, noise, dice, 150));
  return request;
}

const Case kSand{"hypoplastic/Toyoura-HG99",
                 {{"critical_friction_angle_deg", 33},
                  {"granulate_hardness_kPa", 1.2e6},
                  {"peak_exponent", 0.25},
                  {"stiffness_exponent", 1.8}},
                 {{Imposed::drained, 100, 0.72},
                  {Imposed::drained, 300, 0.90},
                  {Imposed::undrained, 200, 0.95}}};

const std::vector<Case> kCases = {
    kSand,
    {"mohr_coulomb/Hostun-loose",
     {{"young_modulus_kPa", 33e3},
      {"friction_angle_deg", 31},
      {"dilation_angle_deg", 4},
      {"pressure_exponent", 0.4}},
     {{Imposed::drained, 100, 0.8}, {Imposed::drained, 400, 0.8}}},
    {"cam_clay/check",
     {{"compression_slope", 0.16}, {"swelling_slope", 0.03}, {"critical_stress_ratio", 1.15}},
     {{Imposed::drained, 100, 0.9}, {Imposed::undrained, 200, 0.8}}},
    {"norsand/S28-true-state",
     {{"critical_stress_ratio", 1.22}, {"hardening_modulus", 80}, {"shear_modulus_kPa", 30e3}},
     {{Imposed::drained, 100, 0.85}, {Imposed::undrained, 200, 1.02}}},
    {"sanisand/S28-general",
     {{"critical_stress_ratio", 1.22}, {"hardening_factor", 2.2}, {"dilatancy_factor", 0.7}},
     {{Imposed::drained, 100, 0.85}, {Imposed::undrained, 200, 1.05}}}};

}  // namespace

TEST_CASE("exact tests give the true parameters back") {
  for (const Case& c : kCases) {
    INFO(c.start);
    const Calibration found = calibrate(request_of(c));
    CHECK(found.cost < 1e-6);
    REQUIRE(found.parameters.size() == c.truth.size());
    for (const auto& [key, value] : c.truth)
      for (const auto& p : found.parameters)
        if (p.key == key) {
          INFO(key);
          CHECK(p.determined);
          CHECK(p.value == Approx(value).epsilon(0.01));
        }
    CHECK(found.start_cost.value() > found.cost);
  }
}

TEST_CASE("seeds end in one optimum, and pieces merged are a run in one go") {
  CalibrationRequest request = request_of(kSand, {0.5, 2e-5});
  request.searches = 3;
  const Calibration whole = calibrate(request);
  CHECK(whole.searches == 3);
  CHECK(whole.ended_at_best == 3);
  CHECK(whole.optima.size() == 1);
  CHECK_FALSE(whole.interrupted);

  std::vector<std::string> files;
  for (const int index : {2, 1}) {
    const auto ends = run_searches(request, index, 2, {}, [] { return true; });
    files.push_back("calibration_piece_" + std::to_string(index) + ".json");
    std::ofstream(files.back()) << calibration_piece_json(request, ends, index, 2);
  }
  const auto merged = conclude(request, merged_searches(request, files), {}, [] { return true; });
  CHECK(calibration_json(merged) == calibration_json(whole));
  CHECK(calibrated_toml(merged, "x") == calibrated_toml(whole, "x"));

  CHECK_THROWS_WITH(merged_searches(request, {files[0]}), Contains("piece 1 of 2 is missing"));
  request.seed = 9;
  CHECK_THROWS_WITH(merged_searches(request, files), Contains("is a piece of another calibration"));
  for (const auto& file : files) std::remove(file.c_str());
}

TEST_CASE("a parameter that the tests do not determine is named, the others hold") {
  // At one pressure alone Young's modulus and its growth with p' are one number.
  Case c = kCases[1];
  c.tests = {{Imposed::drained, 100, 0.8}, {Imposed::drained, 100, 0.8}};
  c.truth = {{"young_modulus_kPa", 33e3}, {"friction_angle_deg", 31}, {"dilation_angle_deg", 4}};
  CHECK(std::ranges::all_of(calibrate(request_of(c)).parameters, &ParameterEstimate::determined));
  c.truth.emplace_back("pressure_exponent", 0.4);
  const auto pair = calibrate(request_of(c));
  REQUIRE(pair.parameters.size() == 4);
  for (const auto& p : pair.parameters) {
    INFO(p.key);
    if (p.key == "friction_angle_deg" || p.key == "dilation_angle_deg") CHECK(p.determined);
  }
  CHECK(std::ranges::any_of(pair.parameters, [](const auto& p) {
    return !p.determined && (p.key == "young_modulus_kPa" || p.key == "pressure_exponent");
  }));
  Case undetermined = kCases[4];
  undetermined.truth = {{"critical_stress_ratio", 1.22}, {"critical_exponent", 0.4}};
  undetermined.tests = {{Imposed::drained, 100, 0.85}};
  undetermined.tests[0].p_eff_kPa = 30;
  // p' stays between 30 and 75 kPa, where p_at^xi hardly tells one exponent from another.
  const auto found = calibrate(request_of(undetermined));
  CHECK(found.parameters[0].determined);
  CHECK(found.parameters[0].value == Approx(1.22).epsilon(0.01));
}

TEST_CASE("how many readings a test has does not move the parameters, where the law does not fit") {
  const auto soil = lab::find_material("hypoplastic/Toyoura-HG99");
  const auto start = lab::find_material("mohr_coulomb/Hostun-loose");
  const auto found = [&](int readings) {
    CalibrationRequest request{.start = start, .searches = 1, .seed = 1, .threads = 2};
    for (const auto& range : lab::shipped_search("mohr_coulomb"))
      if (range.key == "young_modulus_kPa" || range.key == "friction_angle_deg")
        request.free.push_back(range);
    std::mt19937_64 dice(1);
    for (const double p_kPa : {100, 300})
      request.paths.push_back(
          bench::virtual_path(soil, {Imposed::drained, p_kPa, 0.8}, {}, dice, readings));
    return calibrate(request);
  };
  const auto few = found(50), many = found(10000);
  CHECK(many.cost > 1);
  for (std::size_t i = 0; i < 2; ++i) {
    INFO(few.parameters[i].key);
    CHECK(few.parameters[i].value == Approx(many.parameters[i].value).epsilon(0.01));
  }
}

TEST_CASE("stopped at once, a calibration gives the best it has and says so") {
  int asked = 0;
  const auto request = request_of(kSand);
  const Calibration found = calibrate(request, {}, [&] { return ++asked < 3; });
  CHECK(found.interrupted);
  CHECK(found.cost <= found.start_cost.value() * (1 + 1e-9));
  CHECK(calibrated_toml(found, "x").find("interrupted") != std::string::npos);
  CHECK(calibration_json(found).find("\"interrupted\": true") != std::string::npos);
}

TEST_CASE("the parameter file is one like any other") {
  const Calibration found = calibrate(request_of(kSand));
  const std::string text = calibrated_toml(found, set_name_from("there/my sand.toml"));
  const auto sets = lab::read_materials(text, "my_sand.toml");
  REQUIRE(sets.size() == 1);
  CHECK(sets[0].name == "hypoplastic/my-sand");
  CHECK(sets[0].parameters.numbers == found.material.parameters.numbers);
  CHECK(sets[0].void_ratio_range->holds(0.9));

  const Calibration norsand = calibrate(request_of(kCases[3]));
  const auto two = lab::read_materials(calibrated_toml(norsand, "s"), "s.toml");
  REQUIRE(two.size() == 2);
  CHECK(two[0].parameters.numbers.at("pore_fluid_bulk_modulus_kPa") > 0);
  CHECK(two[1].parameters.numbers.at("pore_fluid_bulk_modulus_kPa") == 0);
}

TEST_CASE("eta at collapse is predicted from the other tests") {
  Case c = kSand;
  c.tests = {{Imposed::drained, 100, 0.80},
             {Imposed::undrained, 100, 1.00},
             {Imposed::undrained, 300, 0.98},
             {Imposed::undrained, 200, 1.01}};
  const auto found = calibrate(request_of(c, {0.3, 1e-5}));
  REQUIRE(found.predictions.size() == 3);  // the drained one does not collapse
  for (const auto& p : found.predictions) {
    REQUIRE(p.predicted);
    CHECK(*p.predicted == Approx(p.measured).epsilon(0.02));
    CHECK(p.low < p.high);
  }
}

TEST_CASE("intervals of noisy tests hold the truth about as often as they say") {
  int held = 0, all = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto request = request_of(kSand, {0.5, 2e-5}, seed);
    const SearchSpace space(with(request.start, kSand), request.free);
    const Misfit misfit(space, request.paths, 2, {.tolerance = 1e-7, .step_limit = 4000});
    const auto best = least_squares(misfit, space.start_point(), 20, [] { return true; });
    const auto sure = uncertainty_at(misfit, best.x);
    for (std::size_t i = 0; i < request.free.size(); ++i) {
      const double truth = *value_of(space.start(), request.free[i].key);
      held += sure.parameters[i].low <= truth && truth <= sure.parameters[i].high;
      ++all;
    }
  }
  // 80 of them; by chance alone 70 or fewer once in several thousand times.
  CHECK(all == 80);
  CHECK(held >= 70);
}

TEST_CASE("too few tests for the parameters is one clear line") {
  const auto request = request_of(kSand);
  CHECK_NOTHROW(check_enough(8, {request.paths[0], request.paths[1]}));
  CHECK_THROWS_WITH(
      check_enough(8, {request.paths[0]}),
      "8 free parameters from 1 test: at most 4 can be determined from it; give 2 tests or "
      "more, or fix some with --fix");
  CHECK_THROWS_WITH(check_enough(3, {}), Contains("no test to calibrate on"));
}
