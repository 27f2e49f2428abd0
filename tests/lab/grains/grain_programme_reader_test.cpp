// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_programme_reader.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "lab/base/bad_input.hpp"
#include "sim/mechanics/axisymmetric.hpp"
#include "tests/lab/grains/small_programme.hpp"

using namespace triax;
using namespace triax::lab;
using Catch::Contains;
using triax::test::kSmallGrains;
using triax::test::replaced;

namespace {

void programme_refused(const std::string& text, const std::string& because) {
  INFO(text);
  try {
    read_grain_programme(text, "g.toml");
    FAIL_CHECK("was taken");
  } catch (const BadInput& error) {
    CHECK_THAT(error.what(), Catch::StartsWith("g.toml:") && Contains(because));
    CHECK_THAT(error.what(), !Contains("\n"));
  }
}

}  // namespace

TEST_CASE("a programme of grains is read in SI, with what it does not say at the paper's values") {
  const GrainProgramme p = read_grain_programme(kSmallGrains, "g.toml");
  CHECK(p.name == "small");
  CHECK(p.grains.grains == 200);
  CHECK(p.grains.grading == sim::paper_grading());
  CHECK(p.grains.compaction.pressure_pa == 1e5);
  CHECK(p.grains.compaction.friction_angle == Approx(sim::radians(20)));
  CHECK(!p.grains.search);
  CHECK(p.law.friction_angle == Approx(sim::radians(30)));
  CHECK(p.law.stiffness_over_diameter_pa == 356e6);
  CHECK(p.law.reading == sim::StiffnessReading::in_series);
  REQUIRE(p.stages.size() == 7);
  CHECK(p.stages[0].from == kAsMade);
  CHECK(p.stages[1].from == "isotropic");
  CHECK(p.stages[2].from == "a point");
  CHECK(p.stages[2].save);
  CHECK(p.stages[5].from == "path");
  const auto& drained = std::get<GrainPathStage>(p.stages[1].work);
  CHECK(drained.path.kind == sim::GrainPathKind::drained);
  CHECK(drained.path.pressure_pa == 120e3);
  CHECK(drained.path.axial_strain == Approx(0.005));
  REQUIRE(drained.path.marks.size() == 1);
  CHECK(drained.path.marks[0].value == 0.2);
  CHECK(drained.mark_names == std::vector<std::string>{"a point"});
  CHECK(std::get<GrainPathStage>(p.stages[4].work).path.ratio == 0.9);
  CHECK(std::get<GrainRestStage>(p.stages[5].work).strain_held);
  CHECK(!std::get<GrainRestStage>(p.stages[2].work).strain_held);
  CHECK(std::get<GrainPerturbationStage>(p.stages[6].work).perturbation.load_step_pa == 100);
}

TEST_CASE("undrained is the strain path R = 1, a porosity is sought, a grading is the user's") {
  auto text =
      replaced(kSmallGrains, "action = \"strain_path\"\nfrom = \"isotropic\"\nstrain_path_R = 0.9",
               "action = \"undrained\"");
  text = replaced(text, "compaction_friction_deg = 20.0",
                  "porosity = 0.41\ngrading = {diameter_mm = [1, 2], share_pct = [0, 100]}");
  const GrainProgramme p = read_grain_programme(text, "g.toml");
  const auto& path = std::get<GrainPathStage>(p.stages[4].work).path;
  CHECK(path.kind == sim::GrainPathKind::strain_path);
  CHECK(path.ratio == 1);
  REQUIRE(p.grains.search);
  CHECK(p.grains.search->porosity == 0.41);
  CHECK(p.grains.grading.diameter_m == std::vector<double>{0.001, 0.002});
  CHECK(p.grains.grading.share == std::vector<double>{0, 1});
}

TEST_CASE("a state file stands beside the programme and has its own law") {
  const std::string text = R"([run]
name = "again"
[specimen]
state = "made.grains"
)";
  const GrainProgramme p = read_grain_programme(text, "there/g.toml");
  CHECK(p.grains.state_file == "there/made.grains");
  CHECK(p.files == std::vector<std::string>{"there/g.toml", "there/made.grains"});
  programme_refused(text + "[contact]\ndamping = 0.1\n", "its contact law");
  programme_refused(text + "grains = 4\n", "grains");
  const auto packed =
      replaced(text, "state = \"made.grains\"", "packing = \"p.txt\"\npacking_axis = \"y\"");
  const GrainProgramme q = read_grain_programme(packed + "[contact]\ndamping = 0.1\n", "g.toml");
  CHECK(q.grains.packing_file == "p.txt");
  CHECK(q.grains.packing_axis == 1);
  CHECK(q.law.damping == 0.1);
  CHECK_FALSE(q.grains.made());
  programme_refused(replaced(packed, "\"y\"", "\"w\""), "x, y or z");
}

TEST_CASE("what makes no sense in a programme of grains is refused with file, line and key") {
  const auto with = [](const std::string& from, const std::string& to) {
    return replaced(kSmallGrains, from, to);
  };
  programme_refused(with("grains = 200", "grains = 2"), "grains");
  programme_refused(with("grains = 200", "grainz = 200"), "grainz");
  programme_refused(with("pressure_kPa = 100.0", "pressure_kPa = 0"), "pressure_kPa");
  programme_refused(with("compaction_friction_deg = 20.0", ""),
                    "either compaction_friction_deg or porosity");
  programme_refused(
      with("compaction_friction_deg = 20.0", "compaction_friction_deg = 20\nporosity = 0.4"),
      "give either");
  programme_refused(with("compaction_friction_deg = 20.0", "compaction_friction_deg = 95"),
                    "compaction_friction_deg");
  programme_refused(
      with("seed = 3", "seed = 3\ngrading = {diameter_mm = [2, 1], share_pct = [0, 100]}"),
      "grading");
  programme_refused(with("friction_angle_deg = 30.0", "stiffness_reading = \"parallel\""),
                    "in_series");
  programme_refused(with("action = \"drained\"", "action = \"draned\""), "drained");
  programme_refused(with("strain_rate_per_s = 0.5", "strain_rate_per_s = 0"), "must not be 0");
  programme_refused(with("radial_stress_kPa = 120.0\n", ""), "radial_stress_kPa");
  programme_refused(with("strain_path_R = 0.9", "strain_path_R = 0"), "strain_path_R");
  programme_refused(with("quantity = \"stress_ratio\"", "quantity = \"eta\""), "stress_ratio");
  programme_refused(with("load_step_Pa = 100.0\n", ""), "load_step_Pa, kinetic_energy_J or both");
  programme_refused(with("from = \"a point\"", "from = \"a pint\""), "a point");
  programme_refused(with("from = \"isotropic\"", "from = \"hit\""), "not a stage or mark before");
  programme_refused(with("name = \"held\"", "name = \"a point\""), "lead to the same file names");
  programme_refused(with("name = \"held\"", "name = \"a:point\""), "lead to the same file names");
  programme_refused(with("name = \"held\"", "name = \"specimen\""), "is reserved");
  programme_refused("", "run");
}

TEST_CASE("every sample of grains is a programme") {
  int samples = 0;
  for (const auto& entry : std::filesystem::directory_iterator("samples/grains"))
    if (entry.path().extension() == ".toml") {
      INFO(entry.path());
      CHECK_NOTHROW(load_grain_programme(entry.path().string()));
      ++samples;
    }
  CHECK(samples >= 4);
}
