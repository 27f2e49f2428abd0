// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe_options.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax;
using Catch::Contains;

namespace {

src::ProbeOptions parsed(const std::string& line) {
  CLI::App app;
  src::ProbeOptions options;
  src::add_probe_options(app, options);
  app.parse(line);
  return options;
}

}  // namespace

TEST_CASE("probes are 1 kPa every 10 degrees unless something else is asked for") {
  const auto usual = src::checked_probing(parsed(""));
  CHECK(usual.kind == sim::ProbeKind::stress);
  CHECK(usual.plane == sim::ProbePlane::axisymmetric);
  CHECK(usual.norm == 1000);
  CHECK(usual.directions == 36);
  CHECK_FALSE(usual.finite);
  const auto other = src::checked_probing(
      parsed("--strain --norm-strain 1e-6 --step 0.5 --finite --plane plane-strain"));
  CHECK(other.kind == sim::ProbeKind::strain);
  CHECK(other.plane == sim::ProbePlane::plane_strain);
  CHECK(other.norm == 1e-6);
  CHECK(other.directions == 720);
  CHECK(other.step_deg() == 0.5);
  CHECK(other.finite);
}

TEST_CASE("probes that make no sense are bad input") {
  const auto says = [](const std::string& line, const std::string& words) {
    INFO(line);
    CHECK_THROWS_WITH(src::checked_probing(parsed(line)), Contains(words));
    CHECK_THROWS_AS(src::checked_probing(parsed(line)), lab::BadInput);
  };
  says("--step 0", "--step 0: out of range; expected a number");
  says("--step nan", "--step nan");
  says("--step 7", "it must divide 360 degrees");
  says("--step 90", "0.01 to 45");
  says("--norm-kPa=-1", "--norm-kPa -1");
  says("--norm-kPa inf", "--norm-kPa inf");
  says("--strain --norm-strain 1", "--norm-strain 1");
  says("--norm-strain 1e-5", "needs --strain");
  says("--strain --norm-kPa 1", "without --strain");
}

TEST_CASE("several values make several states") {
  const auto options = parsed("--p-kPa 70 --eta 0.5,0.6,0.7");
  CHECK(options.eta == std::vector<double>{0.5, 0.6, 0.7});
  CHECK(parsed("--stress-kPa 100,60").stress_kPa == std::vector<double>{100, 60});
  CHECK(parsed("--p-kPa 70 --q-kPa=-5,10").q_kPa == std::vector<double>{-5, 10});
}

TEST_CASE("exactly one state is asked for, with what belongs to it") {
  for (const char* line :
       {"--p-kPa 70 --eta 0.5", "--p-kPa 70 --q-kPa 10,20", "--stress-kPa 100,60",
        "--stress-kPa 100,60,60", "--stress-kPa 100,80,60 --plane plane-strain", "--test 26",
        "--test 26 --at peak", "--path p.toml", "--path p.toml --every 5"}) {
    INFO(line);
    CHECK_NOTHROW(src::check_state_options(parsed(line)));
  }
  const auto says = [](const std::string& line, const std::string& words) {
    INFO(line);
    CHECK_THROWS_WITH(src::check_state_options(parsed(line)), Contains(words));
    CHECK_THROWS_AS(src::check_state_options(parsed(line)), lab::BadInput);
  };
  says("", "no state is given");
  says("--p-kPa 70 --eta 0.5 --test 26", "more than one kind");
  says("--p-kPa 70", "--p-kPa needs --eta or --q-kPa");
  says("--p-kPa 70 --eta 0.5 --q-kPa 5", "exclude each other");
  says("--p-kPa 0 --eta 0.5", "--p-kPa 0");
  says("--p-kPa 1e9 --eta 0.5", "--p-kPa 1e+09");
  says("--p-kPa 70 --eta 0.5,nan", "--eta nan");
  says("--eta 0.5 --test 26", "--eta needs --p-kPa");
  says("--stress-kPa 100", "has 1 value");
  says("--stress-kPa 100,80,60", "is not axisymmetric");
  says("--stress-kPa 100,60 --at peak", "--at needs --test");
  says("--test 26 --every 2", "--every needs --path");
  says("--path p.toml --every 0", "--every 0");
  says("--p-kPa 70 --eta 0.5 --axial-strain 0.1", "--axial-strain needs");
  says("--p-kPa 70 --eta 0.5 --R 1", "--R needs --control, --output or --json");
}

TEST_CASE("in three dimensions the step divides half a turn, and nothing of a plane is asked") {
  const auto probing = src::checked_sphere(parsed("--plane 3d --step 5 --norm-kPa 2"));
  CHECK(probing.rings == 36);
  CHECK(probing.norm == 2000);
  for (const char* line : {"--plane 3d --step 45", "--plane 3d --step 24", "--plane 3d --finite",
                           "--plane 3d --control", "--plane 3d --R 1", "--plane 3d --probes"}) {
    INFO(line);
    CHECK_THROWS_AS(src::checked_sphere(parsed(line)), lab::BadInput);
  }
}

TEST_CASE("strain paths start from the isotropic state alone") {
  CHECK_NOTHROW(src::check_strain_path_options(parsed("--strain-paths 0.7,1 --p-kPa 100")));
  for (const char* line :
       {"--strain-paths 1", "--strain-paths 0 --p-kPa 100",
        "--strain-paths 1 --p-kPa 100 --eta 0.5", "--strain-paths 1 --p-kPa 100 --test 26",
        "--strain-paths 1 --p-kPa 100 --strain", "--strain-paths 1 --p-kPa 100 --plane 3d",
        "--strain-paths 1 --p-kPa 100 --probes", "--strain-paths 1 --p-kPa 100 --control",
        "--strain-paths 1 --p-kPa 100 --R 1", "--strain-paths 1 --p-kPa 100 --step 5",
        "--strain-paths 1 --p-kPa 100 --norm-kPa 1", "--strain-paths 1 --p-kPa 100 --every 2",
        "--strain-paths 1 --p-kPa 100 --axial-strain 2"}) {
    INFO(line);
    CHECK_THROWS_AS(src::check_strain_path_options(parsed(line)), lab::BadInput);
  }
}

TEST_CASE("a number left out of a list is told") {
  CHECK_THROWS_WITH(parsed("--p-kPa 70 --eta 0.6,,0.7"), Contains("0.6,,0.7"));
  CHECK_THROWS_WITH(parsed("--p-kPa 70 --eta 0.6,"), Contains("--eta"));
  CHECK_THROWS_WITH(parsed("--p-kPa 70 --eta 0.6,x"), Contains("0.6,x"));
  CHECK(parsed("--p-kPa 70 --eta 0.6 --eta 0.7").eta == std::vector<double>{0.6, 0.7});
}

TEST_CASE("conditions of control are two, in the words of path files") {
  const auto parsed_conditions = [](const std::string& text) {
    src::ProbeOptions options;
    options.conditions = {text};
    return src::checked_probing(options).conditions;
  };
  const auto conditions = parsed_conditions("q_kPa = 1, axial_strain + 2*radial_strain = 0");
  REQUIRE(conditions.size() == 1);
  const auto undrained = sim::triaxial_controls()[0].control;
  CHECK((conditions[0].control.stress.row(0) * 1e3).isApprox(undrained.stress.row(0)));
  CHECK(conditions[0].control.strain.row(1).isApprox(undrained.strain.row(1)));
  CHECK(conditions[0].conditions[0] == "q_kPa");
  for (const char* bad : {"q_kPa = 1", "q_kPa = 1, p_kPa = 0, axial_strain = 0", "q_kPa = 1, what",
                          "q_kPa = 0, axial_strain = 0", ""}) {
    INFO(bad);
    CHECK_THROWS_AS(parsed_conditions(bad), lab::BadInput);
  }
}
