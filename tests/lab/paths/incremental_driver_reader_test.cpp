// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/incremental_driver_reader.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "lab/base/bad_input.hpp"
#include "sim/materials/laws.hpp"
#include "sim/point/path_runner.hpp"

using namespace triax::lab;
namespace sim = triax::sim;
using Catch::Contains;
using Tensor = sim::Tensor;

namespace {

const std::string kSand =
    "SANISAND   # Toyoura\n16\n125\n0.05\n1.25\n0.712\n0.934\n0.019\n0.7\n0.01\n7.05\n0.968\n1.1\n"
    "0.704\n3.5\n4\n600\n100   p_at\n";
const std::string kStart = " 6  ntens\n-100\n-100\n-100\n0\n0\n0\n0  nstatv\n";

struct Files {
  std::map<std::string, std::string> texts;
  explicit Files(const std::string& steps) {
    texts = {{"test.inp", "out.txt # a heading\n" + steps},
             {"parameters.inp", kSand},
             {"initialconditions.inp", kStart}};
  }
  IncrementalDriverTest read(IncrementalDriverSettings settings = {.umat = {},
                                                                   .void_ratio = 0.8}) const {
    return read_incremental_driver(
        [this](const std::string& name) {
          const auto found = texts.find(name);
          if (found == texts.end()) throw BadInput(name, 0, "is not there");
          return found->second;
        },
        "folder", settings);
  }
};

IncrementalDriverTest read(const std::string& steps) { return Files(steps).read(); }

std::string refusal(const Files& files,
                    const IncrementalDriverSettings& settings = {.umat = {}, .void_ratio = 0.8}) {
  try {
    files.read(settings);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}
std::string refusal(const std::string& steps) { return refusal(Files(steps)); }

/// The state at the end, which must have been reached.
sim::PathPoint<Tensor> run(const IncrementalDriverTest& test) {
  const auto result = sim::run_path(*test.material.material.tensor, test.path);
  INFO(result.message << " " << result.limiting_variable);
  REQUIRE((result.outcome == sim::StepOutcome::accepted ||
           result.outcome == sim::StepOutcome::inaccurate));
  return result.last;
}

/// σ and ε as the files have them: kPa, tension positive, γ.
double stress(const sim::PathPoint<Tensor>& at, int k) {
  return -at.stress(k) / 1e3 / (k < 3 ? 1 : std::sqrt(2.0));
}
double strain(const sim::PathPoint<Tensor>& at, int k) {
  return -at.strain(k) * (k < 3 ? 1 : std::sqrt(2.0));
}

}  // namespace

TEST_CASE("a drained test is read with its material, start, name and heading, and is run") {
  const auto test = read("*TriaxialE1\n 100 50 1.0\n -0.02\n*End\nwhatever stands here\n");
  CHECK(test.name == "out");
  CHECK(test.heading == "a heading");
  CHECK(test.material.law->name == "sanisand");
  CHECK(test.material.parameters.numbers.at("critical_stress_ratio") == 1.25);
  CHECK(test.path.void_ratio == 0.8);
  CHECK(test.warnings.empty());
  CHECK(test.files[0] == "folder/test.inp");
  REQUIRE(test.path.segments.size() == 1);
  CHECK(test.path.segments[0].rows == 100);
  CHECK(test.path.segments[0].labels[1] == "stress_22_kPa");

  const auto last = run(test);
  CHECK(strain(last, 0) == Approx(-0.02));
  CHECK(stress(last, 1) == Approx(-100));
  const auto& law = *test.material.material.tensor;
  const auto direct = sim::advance_point(law, law.isotropic(100e3, 0.8),
                                         sim::MixedControl<Tensor>::drained_compression(0.02));
  CHECK(last.q() == Approx(direct.state.q()).epsilon(1e-6));
  CHECK(last.q() > 50e3);
}

TEST_CASE("every short form is the set of conditions that its name says") {
  const auto oedometer = run(read("*OedometricE1\n10 5 1 : 5\n-0.01\n"));
  CHECK(strain(oedometer, 0) == Approx(-0.01));
  CHECK(std::abs(strain(oedometer, 1)) < 1e-12);
  const auto loaded = run(read("*OedometricS1\n10 5 1\n-50\n"));
  CHECK(stress(loaded, 0) == Approx(-150));
  CHECK(std::abs(strain(loaded, 2)) < 1e-12);
  const auto triaxial = run(read("*TriaxialS1\n10 5 1\n-50\n"));
  CHECK(stress(triaxial, 0) == Approx(-150));
  CHECK(stress(triaxial, 2) == Approx(-100));
  const auto undrained = run(read("*TriaxialUEq\n10 5 1\n0.01\n"));
  CHECK(strain(undrained, 0) == Approx(-0.01));
  CHECK(std::abs(undrained.strain.head<3>().sum()) < 1e-12);
  const auto load = run(read("*TriaxialUq\n10 5 1\n20\n"));
  CHECK(load.q() / 1e3 == Approx(20));
  CHECK(std::abs(load.strain.head<3>().sum()) < 1e-12);
  const auto test = read("*PureRelaxation\n10 5 1\n*PureCreep\n10 5 1\n*UndrainedCreep\n9 5 1\n");
  CHECK(test.path.segments.size() == 3);
  CHECK(test.warnings.size() == 3);
  CHECK(test.path.segments[2].labels[1] == "q_kPa");
  const auto held = run(test);
  CHECK(stress(held, 0) == Approx(-100));
  CHECK(held.strain.norm() < 1e-12);
}

TEST_CASE("a linear load takes stress and strain in its frame, shear as γ") {
  const auto simple =
      run(read("*LinearLoad\n10 5 1\n*Cartesian\n0 0\n0 0\n1 -10.\n0 0.004 gamma\n0 0\n0 0\n"));
  CHECK(strain(simple, 3) == Approx(0.004));
  CHECK(stress(simple, 2) == Approx(-110));
  CHECK(stress(simple, 3) > 1);
  const auto constant_p =
      run(read("*linearload\n10 5 1\n*Roscoe\n1 0\n1 30\n1 0\n0 0\n0 0\n0 0\n"));
  CHECK(constant_p.p() / 1e3 == Approx(100));
  CHECK(constant_p.q() / 1e3 == Approx(30));
  const auto isomorph =
      run(read("*LinearLoad\n10 5 1\n*RoscoeIsomorph\n1 0\n1 30\n1 0\n0 0\n0 0\n0 0\n"));
  CHECK(isomorph.q() / 1e3 == Approx(30 * std::sqrt(1.5)));
}

TEST_CASE("restrictions are read as written") {
  const auto undrained = run(read(
      "*ObeyRestrictions\n10 5 1\ned1 + ed2 + ed3 = 0 ! no change of volume\n"
      "1.0*ed2 - ed3 = 0\n -sd1 + 0.5*sd2 + 5.0e-1*sd3 = 20\ned4=0\ned5=0\n ed6 = -0.0 # no\n"));
  CHECK(undrained.q() / 1e3 == Approx(20));
  CHECK(std::abs(undrained.strain.head<3>().sum()) < 1e-12);
  const std::string rest = "ed2=0\ned3=0\ned4=0\ned5=0\ned6=0\n";
  CHECK_THAT(refusal("*ObeyRestrictions\n1 1 1\nee1 = 0\n" + rest),
             Contains("folder/test.inp:4") && Contains("'ee1'"));
  CHECK_THAT(refusal("*ObeyRestrictions\n1 1 1\ned1\n" + rest), Contains("is not a restriction"));
  CHECK_THAT(refusal("*ObeyRestrictions\n1 1 1\nx*ed1 = 0\n" + rest), Contains("not a factor"));
  CHECK_THAT(refusal("*ObeyRestrictions\n1 1 1\ned1 = ed2\n" + rest), Contains("not a number"));
}

TEST_CASE("a circulating load goes from turning point to turning point") {
  const auto test = read(
      "*Repetition\n1 3\n*CirculatingLoad\n400 5 2.0\n*Roscoe\n0 0 0 0\n1 10 0 0\n0 0 0 0\n"
      "0 0 0 0\n0 0 0 0\n0 0 0 0\n");
  REQUIRE(test.path.segments.size() == 3);
  CHECK(test.path.segments[0].conditions.increment(1) == Approx(10));
  CHECK(test.path.segments[1].conditions.increment(1) == Approx(-20));
  CHECK(test.path.segments[2].conditions.increment(1) == Approx(10));
  CHECK(test.path.segments[1].rows == 200);
  CHECK(test.path.segments[2].repeat == 3);
  CHECK(test.path.segments[2].repeat_from == 0U);
  CHECK(std::abs(run(test).q()) < 1);
}

TEST_CASE("components out of phase, or a drift, make a polygon of as many sides as increments") {
  const auto test = read(
      "*CirculatingLoad\n40 5 1\n*Roscoe\n1 6 1.5707963267948966 0\n1 10 0 4\n0 0 0 0\n0 0 0 0\n"
      "0 0 0 0\n0 0 0 0\n");
  REQUIRE(test.path.segments.size() == 40);
  sim::Vector<Tensor> sum = sim::Vector<Tensor>::Zero();
  double highest = 0;
  for (const auto& segment : test.path.segments) {
    sum += segment.conditions.increment;
    highest = std::max(highest, sum(1));
  }
  CHECK(sum(0) == Approx(0).margin(1e-12));
  CHECK(sum(1) == Approx(4));
  CHECK(highest == Approx(10 + 4 * 0.25).epsilon(0.02));
}

TEST_CASE("an oscillation that a repetition takes up in another phase is written out") {
  const std::string quarter =
      "*CirculatingLoad\n8 5 1\n*Roscoe\n0 0 0 0\n1 10 0 0\n0 0 0 0\n"
      "0 0 0 0\n0 0 0 0\n0 0 0 0\n*TriaxialUq\n8 5 0.25\n0\n";
  const auto test = read("*Repetition\n2 2\n" + quarter);
  REQUIRE(test.path.segments.size() == 7);  // 3 + 1, then a start at the turning point: 2 + 1
  CHECK(test.path.segments[4].conditions.increment(1) == Approx(-20));
  for (const auto& segment : test.path.segments) CHECK(segment.repeat == 1);
}

TEST_CASE("a repetition runs its steps together") {
  const auto test = read(
      "*TriaxialUq\n50 5 1\n10\n*Repetition\n2 4\n*TriaxialUq\n50 5 1\n-20\n*TriaxialUq\n50 5 "
      "1\n20\n*End\n");
  REQUIRE(test.path.segments.size() == 3);
  CHECK(test.path.segments[1].repeat == 1);
  CHECK(test.path.segments[2].repeat == 4);
  CHECK(test.path.segments[2].repeat_from == 1U);
  CHECK(segment_order(test.path).size() == 9);
}

TEST_CASE("a step ends where its condition is met") {
  const auto test = read(
      "*OedometricE1 ? s1 < -180\n100 5 1\n-0.05\n*OedometricE1?-2*ev > -0.01\n"
      "100 5 1\n0.05\n");
  const auto first = test.path.segments[0].end.at(0);
  CHECK(first.quantity == sim::PathQuantity::effective_stress_component);
  CHECK(first.above == 180e3);
  CHECK_FALSE(first.below);
  const auto second = test.path.segments[1].end.at(0);
  CHECK(second.quantity == sim::PathQuantity::volumetric_strain);
  CHECK(second.below == 0.005);
  auto only_first = test;
  only_first.path.segments.resize(1);
  CHECK(stress(run(only_first), 0) == Approx(-180));

  CHECK(read("*TriaxialUEq ? q > 20\n10 5 1\n0.01\n").warnings.size() == 1);
  CHECK_THAT(refusal("*TriaxialUEq ? q < -20\n10 5 1\n0.01\n"), Contains("without sign"));
  CHECK_THAT(refusal("*TriaxialUEq ? s1 + s2 < -20\n10 5 1\n0.01\n"), Contains("on a sum"));
  CHECK_THAT(refusal("*TriaxialUEq ? v7 > 1\n10 5 1\n0.01\n"), Contains("'v7'"));
  CHECK_THAT(refusal("*TriaxialUEq ? p\n10 5 1\n0.01\n"), Contains("is not a condition"));
}

TEST_CASE("an imported table is followed row by row") {
  Files files(
      "*ImportFile load.dat | 3\n100 5 1\n*Cartesian\n0 2 * -0.01\n1 0\n1 3\n0 0\n0 0\n0 0\n");
  files.texts["load.dat"] = "time eps sigma\n0 0 5\n1 0.1 4\n2 0.3 5\n";
  const auto test = files.read();
  REQUIRE(test.path.segments.size() == 2);
  const auto last = run(test);
  CHECK(strain(last, 0) == Approx(-0.003));
  CHECK(stress(last, 2) == Approx(-100));
  CHECK(test.path.segments[0].conditions.increment(2) == Approx(-1));
  CHECK(test.files.back() == "folder/load.dat");
  files.texts["load.dat"] = "0 0 5\n1 x 4\n";
  CHECK_THAT(refusal(files), Contains("load.dat:2: column 2"));
  files.texts.erase("load.dat");
  CHECK_THAT(refusal(files), Contains("load.dat: is not there"));
}

TEST_CASE("what is no set of linear conditions is refused by name, what is unknown with the next") {
  CHECK_THAT(refusal("*DeformationGradient\n"),
             Contains("folder/test.inp:2: *DeformationGradient"));
  CHECK_THAT(refusal("*PerturbationsS\n"), Contains("*PerturbationsS"));
  CHECK_THAT(refusal("*TriaxialE\n"), Contains("did you mean '*TriaxialE1'"));
  CHECK_THAT(refusal("*LinearLoad\n1 1 1\n*Rosco\n"), Contains("did you mean '*Roscoe'"));
  CHECK_THAT(refusal("*LinearLoad\n1 1 1\n*Roscoe\n2 1\n"), Contains("test.inp:5"));
  CHECK_THAT(refusal("*TriaxialE1\n0 1 1\n-0.1\n"), Contains("number of increments is 0"));
  CHECK_THAT(refusal("*TriaxialE1\n10 1 1\n"), Contains("the change should follow"));
  CHECK_THAT(refusal(""), Contains("no step is given"));
  Files nameless("");
  nameless.texts["test.inp"] = "*TriaxialE1\n1 1 1\n-0.1\n";
  CHECK_THAT(refusal(nameless), Contains("name of the output"));
}

TEST_CASE(
    "a material that triax does not know, or without void ratio, is refused with the remedy") {
  Files files("*TriaxialE1\n1 1 1\n-0.1\n");
  CHECK_THAT(refusal(files, {}), Contains("void_ratio=NUMBER"));
  files.texts["parameters.inp"] = "NORSANDX\n1\n7000\n";
  CHECK_THAT(refusal(files), Contains("folder/parameters.inp") && Contains("umat=libNAME.so"));
  files.texts["parameters.inp"] = "sanisand\n2\n125\n0.05\n";
  CHECK_THAT(refusal(files), Contains("is missing"));
  files.texts["parameters.inp"] = "sanisand\n3\n7000\n1\n";
  CHECK_THAT(refusal(files), Contains("parameters.inp:4") && Contains("property 3"));
}

TEST_CASE("the void ratio may be a state variable; those that are missing are zero") {
  Files files("*TriaxialE1\n1 1 1\n-0.001\n");
  files.texts["initialconditions.inp"] = "3\n-90\n-100\n-100\n8\n0\n0.77\n";
  const auto test = files.read({.umat = {}, .void_ratio = {}, .void_ratio_index = 2});
  CHECK(test.path.void_ratio == 0.77);
  CHECK(test.path.stress(0) == Approx(90e3));
  CHECK(test.warnings.size() == 1);
  CHECK_THAT(refusal(files, {.umat = {}, .void_ratio = {}, .void_ratio_index = 9}),
             Contains("void_ratio_index=9"));
}

TEST_CASE("Modified Cam-Clay takes its void ratio and preconsolidation from the state variables") {
  if (sim::find_law("cam_clay") == nullptr) {
    WARN("skipped: cam_clay is not there");
    return;
  }
  Files files("*TriaxialUEq\n100 30 100\n0.1\n*END\n");
  files.texts["parameters.inp"] = "    MCC      cmname\n 4 nprops\n0.1\n0.01\n1.0\n0.3\n";
  files.texts["initialconditions.inp"] =
      "6\n-200\n-200\n-200\n0\n0\n0\n8\n0.8\n0\n0\n0\n0\n0\n0\n400 pc\n";
  const auto test = files.read({});
  CHECK(test.path.void_ratio == 0.8);
  CHECK(test.material.parameters.numbers.at("overconsolidation_ratio") == Approx(2));
  const auto last = run(test);
  // Undrained critical state: p = p₀ (OCR/2)^((λ − κ)/λ), q = M p.
  const double critical = 200e3 * std::pow(2.0 / 2, 0.9);
  CHECK(last.p() == Approx(critical).epsilon(1e-3));
  CHECK(last.q() == Approx(critical).epsilon(1e-3));
}

TEST_CASE("hypoplasticity is known by either of its lists of sixteen numbers") {
  if (sim::find_law("hypoplastic") == nullptr) {
    WARN("skipped: hypoplastic is not there");
    return;
  }
  Files files("*OedometricE1\n10 5 1\n-0.001\n");
  files.texts["parameters.inp"] =
      "HYPO\n16\n30\n0\n5.8e6\n0.28\n0.53\n0.84\n1.0\n0.13\n1.05\n5\n2\n1e-4\n0.5\n6\n0\n0.7\n";
  const auto one = files.read({});
  CHECK(one.path.void_ratio == 0.7);
  CHECK(one.path.memory.size() == 6);
  files.texts["parameters.inp"] =
      "Hypo-VW96_sand\n16\n0.5235987755982988\n0.3\n5.8e6\n0.28\n0.53\n0.84\n1.0\n0.13\n1."
      "05\n2\n5\n"
      "1e-4\n0.5\n6\n0\n0\n";
  files.texts["initialconditions.inp"] = "6\n-100\n-100\n-100\n0\n0\n0\n20\n0.7\n";
  const auto other = files.read({});
  CHECK(other.path.void_ratio == 0.7);
  CHECK(run(one).stress(0) == Approx(run(other).stress(0)).epsilon(1e-9));
  files.texts["parameters.inp"] =
      "HYPO\n16\n30\n0\n5.8e6\n0.28\n0.53\n0.84\n1.0\n0.13\n1.05\n5\n2\n1e-4\n0.5\n6\n2e6\n0.7\n";
  CHECK_THAT(refusal(files), Contains("bulk modulus of the water"));
}

#ifdef TRIAX_UMAT_FIXTURE
TEST_CASE("a library takes name, properties and state variables as they stand") {
  Files files("*TriaxialS1\n10 5 1\n-50\n");
  files.texts["parameters.inp"] = "CONE  # of the tests\n6\n20e3\n12e3\n1.2\n0.3\n5\n0\n";
  files.texts["initialconditions.inp"] = "6\n-100\n-100\n-100\n0\n0\n0\n12\n0.8\n";
  const auto test =
      files.read({.umat = TRIAX_UMAT_FIXTURE, .void_ratio = {}, .void_ratio_index = 1});
  CHECK(test.material.law->name == "umat");
  CHECK(test.material.parameters.texts.at("name") == "CONE");
  const auto last = run(test);
  const double young = 9 * 20e3 * 12e3 / (3 * 20e3 + 12e3);
  CHECK(strain(last, 0) == Approx(-50 / young).epsilon(1e-9));
  CHECK(last.void_ratio < 0.8);
}

TEST_CASE("a slow library is given time by a setting, beside umat only") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "triax_incremental_driver_time_test";
  fs::create_directories(folder);
  Files files("*TriaxialS1\n10 5 1\n-50\n");
  files.texts["parameters.inp"] = "CONE\n6\n20e3\n12e3\n1.2\n0.3\n5\n0\n";
  files.texts["initialconditions.inp"] = "6\n-100\n-100\n-100\n0\n0\n0\n12\n0.8\n";
  for (const auto& [name, text] : files.texts) std::ofstream(folder / name) << text;
  std::vector<std::pair<std::string, std::string>> settings = {
      {"umat", TRIAX_UMAT_FIXTURE}, {"void_ratio_index", "1"}, {"time_limit_s", "120"}};
  const auto described = describe_incremental_driver(folder.string(), settings);
  CHECK(described.material.parameters.numbers.at("time_limit_s") == 120);
  CHECK(settings.empty());
  settings = {{"umat", TRIAX_UMAT_FIXTURE}, {"time_limit_s", "0"}};
  CHECK_THROWS_WITH(describe_incremental_driver(folder.string(), settings),
                    Contains("time_limit_s='0'"));
  fs::remove_all(folder);
}
#endif

TEST_CASE("a folder on disk is recognised and read") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "triax_incremental_driver_test";
  fs::create_directories(folder);
  const Files files("*TriaxialE1\n1 1 1\n-0.001\n");
  for (const auto& [name, text] : files.texts) std::ofstream(folder / name) << text;
  CHECK(is_incremental_driver(folder.string()));
  CHECK(is_incremental_driver((folder / "test.inp").string()));
  CHECK_FALSE(is_incremental_driver("path.toml"));
  const IncrementalDriverSettings settings{.umat = {}, .void_ratio = 0.8};
  CHECK(is_incremental_driver("tests"));
  CHECK_THROWS_WITH(load_incremental_driver("tests", settings), Contains("without a test.inp"));
  CHECK(load_incremental_driver(folder.string(), settings).path.segments.size() == 1);
  CHECK(load_incremental_driver((folder / "test.inp").string(), settings).name == "out");
  for (const char* other : {"parameters.inp", "InitialConditions.inp"})
    CHECK_THROWS_WITH(load_incremental_driver((folder / other).string(), settings),
                      Contains("give its folder, or the test.inp"));
  // As some editors save it.
  std::ofstream(folder / "initialconditions.inp")
      << "\xEF\xBB\xBF" << files.texts.at("initialconditions.inp");
  CHECK(load_incremental_driver(folder.string(), settings).path.segments.size() == 1);
  fs::remove(folder / "parameters.inp");
  CHECK_THROWS_WITH(load_incremental_driver(folder.string(), settings), Contains("parameters.inp"));
  fs::remove_all(folder);
}
