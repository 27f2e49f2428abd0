// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_run.hpp"

#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>

#include "lab/base/bad_input.hpp"
#include "lab/grains/grain_files.hpp"
#include "lab/grains/grain_programme_reader.hpp"
#include "lab/grains/grain_words.hpp"
#include "sim/grains/state/triaxial_axes.hpp"
#include "tests/lab/grains/small_programme.hpp"

using namespace triax;
using namespace triax::lab;
using triax::test::kSmallGrains;
using triax::test::replaced;

namespace {

struct Told {
  GrainsMade made;
  std::vector<std::string> begun;
  std::map<std::string, sim::GrainState> starts, ends;
  std::map<std::string, GrainStageResult> results;
  std::map<std::string, int> points;
  bool whole = false;
};

/// Runs a programme, which has to live as long as what is told.
Told told_by(const GrainProgramme& programme, int threads = 1) {
  Told told;
  GrainListener listener;
  listener.made = [&](const GrainsMade& made) { told.made = made; };
  listener.stage_started = [&](const GrainStage& stage, const sim::GrainState& state) {
    told.begun.push_back(stage.name);
    told.starts[stage.name] = state;
  };
  listener.point_kept = [&](const GrainStage& stage, const sim::GrainState&,
                            const sim::GrainPathPoint&) { ++told.points[stage.name]; };
  listener.stage_ended = [&](const GrainStage& stage, const sim::GrainState& state,
                             const GrainStageResult& result) {
    told.ends[stage.name] = state;
    told.results[stage.name] = result;
  };
  told.whole = run_grains(programme, {.threads = threads}, {listener});
  return told;
}

const GrainProgramme& small() {
  static const GrainProgramme programme = read_grain_programme(kSmallGrains, "g.toml");
  return programme;
}
const Told& small_run() {
  static const Told told = told_by(small());
  return told;
}

}  // namespace

TEST_CASE("stages of a programme of grains follow each other, each from the state it names") {
  const Told& t = small_run();
  CHECK(t.whole);
  CHECK(t.made.measures.grains_outside == 0);
  CHECK(t.made.state.grains.size() == 200);
  CHECK(t.made.state.law.friction_angle == small().law.friction_angle);
  CHECK(t.begun == std::vector<std::string>{"isotropic", "drained", "at rest", "probes", "path",
                                            "held", "hit"});
  CHECK(t.starts.at("isotropic") == t.made.state);
  CHECK(t.starts.at("drained") == t.ends.at("isotropic"));
  CHECK(t.starts.at("path") == t.ends.at("isotropic"));
  CHECK(t.starts.at("hit") == t.ends.at("held"));
  CHECK(t.ends.at("probes") == t.starts.at("probes"));
  const auto& drained = std::get<sim::GrainPathResult>(t.results.at("drained").outcome);
  REQUIRE(drained.marked.at(0).has_value());
  CHECK(t.starts.at("at rest") == *drained.marked[0]);
  CHECK(t.results.at("isotropic").strain_before.axial == 0);
  CHECK(t.results.at("path").strain_before.axial ==
        axisymmetric_strain(t.made.state.box, t.ends.at("isotropic").box).axial);
  CHECK(t.points.at("drained") == static_cast<int>(drained.points.size()));
  CHECK(t.results.at("drained").steps == t.ends.at("drained").steps - t.starts.at("drained").steps);
}

TEST_CASE("a rest holds what the servos held and what the other walls carried, without motion") {
  const Told& t = small_run();
  const auto before = axisymmetric_stress(t.starts.at("at rest"));
  const auto after = axisymmetric_stress(t.ends.at("at rest"));
  CHECK(after.axial == Approx(before.axial).epsilon(2e-3));
  CHECK(after.radial == Approx(120e3).epsilon(2e-3));
  CHECK(std::get<GrainRest>(t.results.at("at rest").outcome).at_rest);
  CHECK(t.results.at("at rest").after.kinetic_energy_j <
        1e-3 * t.results.at("drained").after.kinetic_energy_j);
  CHECK(at_rest(t.results.at("at rest")) == true);
  CHECK(ending(t.results.at("at rest")) == "at rest");
}

TEST_CASE("an equilibrium tells the stress of its path; probes and perturbations have their ends") {
  const Told& t = small_run();
  const auto& held = std::get<GrainRest>(t.results.at("held").outcome);
  CHECK(held.path_stress_pa == sim::path_stress(axisymmetric_stress(t.ends.at("held")), 0.9));
  CHECK(t.ends.at("held").box.length_m(2) == t.starts.at("held").box.length_m(2));
  const auto& rose = std::get<GrainRose>(t.results.at("probes").outcome);
  CHECK(rose.angles.size() == 4);
  CHECK(rose.rose.probes.size() == 4);
  CHECK(rose.rose.null_probe.norm_pa == 0);
  CHECK(t.results.at("probes").steps > 5 * 4000);
  const auto& hit = std::get<sim::PerturbationResult>(t.results.at("hit").outcome);
  CHECK(hit.points.front().stress_share == Approx(1));
}

TEST_CASE("a run of grains has the same bits on two threads") {
  const Told two = told_by(small(), 2);
  for (const char* stage : {"drained", "at rest", "held", "hit"})
    CHECK(two.ends.at(stage) == small_run().ends.at(stage));
  CHECK(
      std::get<GrainRose>(two.results.at("probes").outcome).rose.probes[2].work.lagrangian ==
      std::get<GrainRose>(small_run().results.at("probes").outcome).rose.probes[2].work.lagrangian);
}

TEST_CASE("a saved state goes on as if the run had never ended") {
  const auto file = std::filesystem::temp_directory_path() / "triax-grain-run-test.grains";
  save_state(file.string(), small_run().ends.at("isotropic"));
  std::string text = kSmallGrains.substr(kSmallGrains.find("[[stages]]"));
  text = "[run]\nname = 'on'\n[specimen]\nstate = '" + file.filename().string() + "'\n" +
         text.substr(text.find("[[stages]]", 5));
  text = text.substr(0, text.find("[[stages]]\nname = \"at rest\""));
  const GrainProgramme on = read_grain_programme(text, file.string());
  const Told t = told_by(on);
  CHECK(t.made.trials == 0);
  CHECK(t.ends.at("drained") == small_run().ends.at("drained"));
  std::filesystem::remove(file);
  CHECK_THROWS_AS(told_by(on), BadInput);
}

TEST_CASE("the fewest grains of the widest grading find a place, too") {
  const auto text = replaced(kSmallGrains, "grains = 200", "grains = 8");
  const GrainProgramme few =
      read_grain_programme(text.substr(0, text.find("[[stages]]\nname = \"drained\"")), "g.toml");
  CHECK(told_by(few).made.measures.grains_outside == 0);
}

TEST_CASE("a run that is stopped says so, and tells nothing of the stage under way") {
  for (const char* at : {"compressing the cloud", "following the path", "settling", "perturbed"}) {
    INFO(at);
    std::vector<std::string> ended;
    std::string begun;
    bool asked = false;
    GrainListener listener;
    listener.stage_started = [&](const GrainStage& stage, const sim::GrainState&) {
      begun = stage.name;
    };
    listener.stage_ended = [&](const GrainStage& stage, const sim::GrainState&,
                               const GrainStageResult&) { ended.push_back(stage.name); };
    const auto progress = [&](double, const std::string& what) {
      asked = asked || what == at;
      return !asked;
    };
    CHECK_FALSE(run_grains(small(), {1, progress}, {listener}));
    CHECK(asked);
    CHECK(std::find(ended.begin(), ended.end(), begun) == ended.end());
  }
}

TEST_CASE("what cannot be carried out fails with the name of the stage") {
  const auto fails = [](const std::string& text, const std::string& because) {
    const GrainProgramme programme = read_grain_programme(text, "g.toml");
    CHECK_THROWS_WITH(told_by(programme), Catch::Contains(because));
    CHECK_THROWS_AS(told_by(programme), WorkFailed);
  };
  fails(replaced(kSmallGrains, "value = 0.2", "value = 2.9"),
        "stage 'at rest': its start 'a point' was never reached");
  fails(replaced(kSmallGrains, "compaction_friction_deg = 20.0", "porosity = 0.25"), "denser");
  fails(replaced(kSmallGrains, "compaction_friction_deg = 20.0",
                 "compaction_friction_deg = 20\nmost_steps = 600"),
        "did not reach equilibrium");
}
