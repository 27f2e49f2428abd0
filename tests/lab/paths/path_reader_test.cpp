// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/path_reader.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "lab/base/bad_input.hpp"
#include "tests/lab/paths/path_text.hpp"

using namespace triax::lab;
using namespace triax;
using Catch::Contains;
using test::kPath;
using test::with;

namespace {

void path_refused(const std::string& text, const std::string& because) {
  INFO(text);
  try {
    read_path(text, "p.toml");
    FAIL_CHECK("was taken");
  } catch (const BadInput& error) {
    CHECK_THAT(error.what(), Catch::StartsWith("p.toml") && Contains(because));
  }
}

const std::string kConditions = R"(["axial_strain = 0.02", "radial_stress_kPa = 0"])";

}  // namespace

TEST_CASE("a path is read in SI") {
  const auto description = read_path(
      with(kPath, "void_ratio = 1.0", "void_ratio = 1.0\npore_pressure_kPa = 300.0"), "p.toml");
  CHECK(description.name == "small");
  CHECK(description.tolerance == 1e-8);
  CHECK(description.material.name == "sanisand/S28-general");
  const auto& path = std::get<TriaxialPath>(description.path);
  CHECK(path.stress.isApprox(sim::isotropic<sim::Axisymmetric>(100e3)));
  CHECK(path.pore_pressure == 300e3);
  REQUIRE(path.segments.size() == 1);
  const auto& segment = path.segments[0];
  CHECK(segment.undrained);
  CHECK(segment.rows == 200);
  CHECK(segment.labels == std::vector<std::string>{"axial_strain", "radial_stress_kPa"});
  CHECK(segment.conditions.increment(0) == 0.02);
  CHECK(segment.conditions.strain.row(0).isApprox(Eigen::RowVector2d(1, 0)));
  CHECK_NOTHROW(check_start(description));
}

TEST_CASE("starts: axial and radial stress, six components, memory") {
  const auto anisotropic = read_path(
      with(kPath, "p_eff_kPa = 100.0", "stress_kPa = {axial = 120.0, radial = 90.0}"), "p.toml");
  const auto& flat = std::get<TriaxialPath>(anisotropic.path);
  CHECK(flat.stress.isApprox(sim::components(sim::AxisymmetricStress{120e3, 90e3})));

  const auto six = read_path(
      with(kPath, "p_eff_kPa = 100.0", "stress_kPa = [120.0, 90, 80, 5, 0, 0]\nmemory = [1, 2]"),
      "p.toml");
  const auto& full = std::get<TensorPath>(six.path);
  CHECK(full.stress(2) == 80e3);
  CHECK(full.stress(3) == Approx(5e3 * std::numbers::sqrt2));
  CHECK(full.segments[0].labels.size() == 6);
  CHECK(full.memory == std::vector<double>{1, 2});
}

TEST_CASE("a cartesian segment makes the path one of tensors; triaxial ones go with it") {
  const std::string cartesian = R"(
[[segments]]
name = "shear"
frame = "cartesian"
drainage = "drained"
conditions = ["strain_12 = 0.01", "stress_11_kPa = 0", "strain_22 = 0", "strain_33 = 0",
              "strain_13 = 0", "strain_23 = 0"]
end = [{quantity = "stress_12_kPa", above = 20}]
)";
  const auto description = read_path(kPath + cartesian, "p.toml");
  const auto& path = std::get<TensorPath>(description.path);
  REQUIRE(path.segments.size() == 2);
  CHECK(path.segments[0].conditions.strain.row(2).isApprox(
      (Eigen::Matrix<double, 1, 6>() << 0, 1, -1, 0, 0, 0).finished()));
  REQUIRE(path.segments[1].end.size() == 1);
  CHECK(path.segments[1].end[0].component == 3);
  CHECK(path.segments[1].end[0].above == 20e3);
  path_refused(with(kPath + cartesian, R"(, "strain_23 = 0")", ""),
               "5 conditions are given; expected 6");
}

TEST_CASE("ends and repetitions") {
  const std::string cycle = R"(
[[segments]]
name = "back"
drainage = "undrained"
rows = 7
conditions = ["axial_strain_pct = -2", "radial_stress_kPa = 0"]
end = [{quantity = "eta", below = -0.3}, {quantity = "p_eff_kPa", below = 5}]
repeat = 4
repeat_from = "compression"
)";
  const auto path = std::get<TriaxialPath>(read_path(kPath + cycle, "p.toml").path);
  CHECK(sim::segment_order(path).size() == 8);
  const auto& back = path.segments[1];
  CHECK(back.rows == 7);
  REQUIRE(back.end.size() == 2);
  CHECK(back.end[0].below == -0.3);
  CHECK(back.end[1].below == 5e3);
  CHECK(back.end[1].label == "p_eff_kPa below 5");
  path_refused(with(kPath + cycle, "\"compression\"\nd", "\"back\"\nd"),
               "the name of an earlier segment");
  path_refused(with(kPath + cycle, "repeat_from = \"compression\"", "repeat_from = \"comp\""),
               "did you mean 'compression'?");
  path_refused(with(kPath + cycle, "repeat = 4\n", ""), "needs repeat");
  path_refused(with(kPath + cycle, "repeat = 4", "repeat = 0"), "must be 1 to 100000");
  path_refused(with(kPath + cycle, "rows = 7", "rows = 100000"), "rows of output");
  // Few rows, but four million parts with the repetitions.
  path_refused(with(kPath + cycle, "rows = 7", "rows = 1\nparts = 1000000"), "parts of segments");
  path_refused(with(kPath + cycle, "below = 5", "below = 5, above = 7"), "exactly one");
  path_refused(with(kPath + cycle, "\"eta\"", "\"etta\""), "did you mean 'eta'?");
  path_refused(with(kPath + cycle, "\"eta\"", "\"stress_11_kPa\""), "is not valid");
  path_refused(with(kPath + cycle, "-0.3", "-30"), "must be at least -1.5");
}

TEST_CASE("a table gives a segment a row, run as one") {
  const auto description = load_path("samples/paths/from_table.toml");
  const auto& path = std::get<TriaxialPath>(description.path);
  REQUIRE(path.segments.size() == 9);
  CHECK_FALSE(path.segments[0].goes_on);
  CHECK(path.segments[1].goes_on);
  CHECK(path.segments[0].conditions.increment(0) == 0.001);
  CHECK(path.segments[4].conditions.increment(0) == Approx(-0.001));
  CHECK(path.segments[8].conditions.increment(1) == 10);
  REQUIRE(description.files.size() == 2);
  CHECK(description.files[1] == "samples/paths/from_table.csv");
}

TEST_CASE("what is no path is refused with file, line and remedy") {
  path_refused("", "[path] is missing");
  path_refused("[path]\nname = \"x\"\n", "[start] is missing");
  path_refused(with(kPath, "name = \"small\"\n", ""), "name is missing");
  path_refused(with(kPath, "material = \"sanisand/S28-general\"\n", ""), "material is missing");
  path_refused(with(kPath, "S28-general", "S28-genral"),
               "p.toml:3: [path] material: unknown material");
  path_refused(with(kPath, "p_eff_kPa = 100.0\n", ""), "the effective stress is missing");
  path_refused(with(kPath, "p_eff_kPa", "p_eff_MPa"), "effective stress is missing");
  path_refused(with(kPath, "100.0", "-100.0"), "must be");
  path_refused(with(kPath, "100.0", "1e300"), "must be");
  path_refused(with(kPath, "100.0", "nan"), "must be");
  path_refused(with(kPath, "100.0", "100.0\nstress_kPa = {axial = 1, radial = 1}"), "give either");
  path_refused(with(kPath, "p_eff_kPa = 100.0", "stress_kPa = [1, 2]"), "six components");
  path_refused(with(kPath, "p_eff_kPa = 100.0", "stress_kPa = [1, 2, 3, 4, 5, 1e9]"),
               "six components");
  path_refused(with(kPath, "void_ratio = 1.0\n", ""), "void_ratio is missing");
  path_refused(with(kPath, "void_ratio = 1.0", "void_ratio = 100"), "must be");
  path_refused(with(kPath, "void_ratio = 1.0", "voidratio = 1.0"),
               "is 'voidratio' a misspelling of it?");
  path_refused(kPath.substr(0, kPath.find("[[")), "write [[segments]]");
  path_refused(with(kPath, "\"undrained\"", "\"closed\""), "expected drained or undrained");
  path_refused(with(kPath, "drainage = \"undrained\"\n", ""), "drainage is missing");
  path_refused(with(kPath, "drainage", "frame = \"triaxal\"\ndrainage"),
               "did you mean 'triaxial'?");
  path_refused(with(kPath, kConditions, "[\"axial_strain = 0.02\"]"),
               "1 conditions are given; expected 2");
  path_refused(with(kPath, "conditions = " + kConditions, ""), "conditions are missing");
  path_refused(with(kPath, "axial_strain = 0.02", "axial_strain_kPa = 0.02"), "column 1");
  path_refused(with(kPath, "radial_stress_kPa = 0", "radial_strain = 0"), "total stress");
  path_refused(with(kPath, "radial_stress_kPa = 0", "q_kPa = 0"), "total stress");
  path_refused(with(kPath, "radial_stress_kPa = 0", "axial_strain = 0.01"), "axial_strain");
  path_refused(with(kPath, "axial_strain = 0.02", "volumetric_strain = 0"), "undrained implies");
  path_refused(with(kPath, "0.02", "0"), "at least one must differ from 0");
  path_refused(with(kPath, "0.02", "1e6"), "is out of range");
  path_refused(kPath + "rowz = 3\n", "did you mean 'rows'?");
  path_refused(kPath + "rows = 0\n", "must be 1 to 100000");
  path_refused(kPath + "table = \"x.csv\"\n", "give either table or conditions");
  path_refused(with(kPath, "name = \"small\"", "name = \"small\"\ntolerance = 1.0"), "must be");
  path_refused(kPath + "[parameters]\nfoo = 3\n", "unknown parameter 'foo'");
}

TEST_CASE("parameters of the file, and sets of one's own") {
  const auto changed = read_path(kPath + "[parameters]\nhardening_factor = 2.0\n", "p.toml");
  REQUIRE(changed.parameters.size() == 1);
  CHECK(changed.material.parameters.numbers.at("hardening_factor") == 2.0);
  CHECK(changed.material_name == "sanisand/S28-general");
  CHECK_THROWS_AS(
      read_path(with(kPath, "[start]", "material_file = \"nowhere.toml\"\n[start]"), "p.toml"),
      BadInput);
}

TEST_CASE("the samples are paths that their materials take") {
  int found = 0;
  for (const auto& entry : std::filesystem::directory_iterator("samples/paths")) {
    if (entry.path().extension() != ".toml") continue;
    INFO(entry.path());
    CHECK_NOTHROW(check_start(load_path(entry.path().string())));
    ++found;
  }
  CHECK(found >= 8);
}
