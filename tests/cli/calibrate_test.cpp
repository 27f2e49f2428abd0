// SPDX-License-Identifier: GPL-3.0-or-later
// triax calibrate on stored tests: one clear line for what cannot be, a file that others take.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

using namespace triax::cli_tests;
using Catch::Contains;

namespace {

/// A drained test of an elastic, perfectly plastic soil: E 20 MPa, nu 0.2, phi 30 degrees (M
/// = 1.2), no dilation, at sigma_3' of this many kPa.
std::string drained_record(double radial_kPa, double unit = 1) {
  std::string text =
      "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa,volumetric_strain_pct\n";
  const double strength = 2 * radial_kPa;  // q = 3 (p - sigma_3), q = 1.2 p
  for (int i = 0; i <= 100; ++i) {
    const double strain = 0.0005 * i;
    const double q = std::min(20000 * strain, strength);
    text += std::to_string(100 * strain) + "," + std::to_string(unit * q) + "," +
            std::to_string(unit * (radial_kPa + q / 3)) + "," +
            std::to_string(100 * 0.6 * q / 20000) + "\n";
  }
  return text;
}

void replay(const Workplace& here, const std::string& name, const std::string& text,
            const std::string& sets) {
  std::ofstream(here / (name + ".csv")) << text;
  REQUIRE(here.triax("replay " + name + ".csv " + sets).status == 0);
}

void is_one_line(const Outcome& outcome, const std::string& says) {
  INFO(outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, Contains(says));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

}  // namespace

TEST_CASE("calibrate refuses what cannot be with one clear line") {
  const Workplace here;
  replay(here, "bare", drained_record(100), "");
  is_one_line(here.triax("calibrate mohr_coulomb bare"), "test bare has no void ratio");
  const std::string of = "--set specimen.void_ratio=0.8 --set specimen.material=";
  replay(here, "quartz", drained_record(100), of + "quartz");
  replay(here, "lime", drained_record(200), of + "lime");
  is_one_line(here.triax("calibrate mohr_coulomb quartz lime"),
              "tests of two soils: quartz is of \"quartz\", lime of \"lime\"");
  is_one_line(here.triax("calibrate hypoplastic quartz"), "8 free parameters from 1 test");
  replay(here, "pascal", drained_record(150, 1e3), of + "quartz");
  is_one_line(here.triax("calibrate mohr_coulomb pascal"), "check the unit of its stresses");
  is_one_line(here.triax("calibrate coulomb quartz"), "unknown law 'coulomb'");
  is_one_line(here.triax("calibrate mohr_coulomb quartz --free cohesion"), "--free 'cohesion'");
  is_one_line(here.triax("calibrate mohr_coulomb quartz --piece 1/2"), "--piece needs --output");
  is_one_line(here.triax("calibrate mohr_coulomb quartz --merge quartz.csv"), "quartz.csv");
  is_one_line(here.triax("calibrate mohr_coulomb quartz --output triax.db"), "--output");
}

TEST_CASE("calibrate finds a soil of known parameters, and domain takes the file") {
  const Workplace here;
  const std::string of = "--set specimen.void_ratio=0.8 --set test.name=";
  replay(here, "a", drained_record(100), of + "a");
  replay(here, "b", drained_record(300), of + "b");
  const Outcome found = here.triax(
      "calibrate mohr_coulomb --fix pressure_exponent=0 --searches 2 --output soil.toml --figures "
      "curves --json");
  INFO(found.err);
  REQUIRE(found.status == 0);
  const auto json = nlohmann::json::parse(found.out);
  CHECK(json["cost"].get<double>() < 0.01);
  for (const auto& p : json["parameters"]) {
    if (p["name"] == "young_modulus_kPa")
      CHECK(p["value"].get<double>() == Approx(20000).epsilon(0.01));
    if (p["name"] == "friction_angle_deg")
      CHECK(p["value"].get<double>() == Approx(30).epsilon(0.01));
    if (p["name"] == "dilation_angle_deg") CHECK(std::abs(p["value"].get<double>()) < 0.1);
  }
  CHECK(json["misfits"].size() == 4);
  CHECK(here.has("curves/calibrate_drained.svg"));
  // Perfect plasticity has a limit, M = 6 sin 30/(3 - sin 30) = 1.2, and no domain before it.
  const auto& domain = json["domain"];
  CHECK_THAT(domain["none"].get<std::string>(), Contains("before the plastic limit"));
  CHECK(domain["void_ratio"] == 0.8);
  CHECK(domain["compression"].size() == 7);
  CHECK(domain["compression"][0]["limit"]["value"].get<double>() == Approx(1.2).epsilon(0.01));
  CHECK(domain["compression"][0]["first_unstable"]["value"].is_null());
  CHECK_FALSE(here.has("curves/calibrate_domain.svg"));
  CHECK(here.triax("probe --materials soil.toml --material mohr_coulomb/soil --p-kPa 100 --eta 0.5 "
                   "--void-ratio 0.8")
            .status == 0);
  CHECK(here.triax("calibrate mohr_coulomb --start soil.toml --fix pressure_exponent --searches 1")
            .status == 0);
}
