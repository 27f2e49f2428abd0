// SPDX-License-Identifier: GPL-3.0-or-later
// triax soil from outside: a set of three specimens as document and files, and what bad input gets.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/running.hpp"

using namespace triax::cli_tests;
using nlohmann::json;

namespace {

/// Undrained at constant p', q rises to 1.2 p' like 1 − exp(−ε/1 %) and rests.
std::string record(double p_kPa) {
  std::string text = "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n";
  for (int i = 0; i <= 200; ++i) {
    const double strain = 0.1 * i;
    text += std::to_string(strain) + "," + std::to_string(1.2 * p_kPa * (1 - std::exp(-strain))) +
            "," + std::to_string(p_kPa) + "\n";
  }
  return text;
}

/// Three tests of "sand A", the last of another material where that is given.
struct ThreeSpecimens : Workplace {
  explicit ThreeSpecimens(const std::string& other = "sand A", int count = 3) {
    for (int i = 0; i < count; ++i) {
      const std::string name = "t" + std::to_string(i) + ".csv";
      write(*this / name, record(100.0 * (i + 1)));
      const Outcome outcome = triax(
          "replay " + name + " --set 'specimen.material=" + (i == count - 1 ? other : "sand A") +
          "' --set stages.1.drainage=closed");
      INFO(outcome.err);
      REQUIRE(outcome.status == 0);
    }
  }
};

}  // namespace

TEST_CASE("triax soil gives M and phi' of three specimens, with the files of --output") {
  const ThreeSpecimens here;
  const Outcome outcome = here.triax("soil --json --output out");
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const json soil = json::parse(outcome.out);
  CHECK(soil["group"] == "sand A");
  CHECK(soil["friction"]["critical_stress_ratio"]["value"].get<double>() ==
        Approx(1.2).epsilon(2e-3));
  // M 1.2: sin phi = 3.6/7.2.
  CHECK(soil["strength"]["friction_angle_deg"]["value"].get<double>() == Approx(30).epsilon(2e-3));
  CHECK(here.has("out/soil.toml"));
  CHECK(here.has("out/soil_mohr_circles.svg"));
  CHECK(here.has("out/soil_critical_stress_ratio.csv"));
}

TEST_CASE("triax soil refuses two sands, too few tests and conditions that it cannot read") {
  const ThreeSpecimens two_sands("sand B");
  Outcome outcome = two_sands.triax("soil");
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("the tests are of 2 materials: sand A (2), sand B (1)") !=
        std::string::npos);
  outcome = two_sands.triax("soil --where \"material = 'sand A'\"");
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("there are only 2 tests; trends and intervals need at least 3") !=
        std::string::npos);
  outcome = two_sands.triax("soil --where \"colour = 'red'\"");
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("no such column: colour") != std::string::npos);
  outcome = two_sands.triax("soil --where \"p0_eff_kPa > 1000\"");
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("no test matches --where") != std::string::npos);
}
