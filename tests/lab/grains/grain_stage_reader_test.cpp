// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_stage_reader.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax;
using namespace triax::lab;

TEST_CASE("every action of a stage of grains is one that can be written") {
  for (const std::string& action : grain_actions()) {
    INFO(action);
    const auto table =
        TomlTable::parse("name = 'x'\naction = '" + action +
                             "'\nload_step_Pa = 1\nstrain_path_R = 2\n"
                             "pressure_kPa = 10\nradial_stress_kPa = 11\nstrain_rate_per_s = -0.1\n"
                             "end_axial_strain_pct = 3\nend_stress_ratio = -0.2\nnorm_kPa = 2\n",
                         "s.toml");
    // Keys that belong to other actions are refused by name.
    CHECK_THROWS_WITH(read_grain_stage(table), Catch::StartsWith("s.toml:"));
  }
  const auto stage = read_grain_stage(TomlTable::parse(
      "name = 'x'\naction = 'probes'\nnorm_kPa = 2\ndirections = 8\nstress_error_Pa = 3\n", "s"));
  const auto& probes = std::get<GrainProbeStage>(stage.work);
  CHECK(probes.probing.norm_pa == 2000);
  CHECK(probes.probing.stress_error_pa == 3);
  CHECK(probes.directions == 8);
  CHECK(probes.probing.kind == sim::ProbeKind::stress);
  CHECK(stage.from.empty());
}

TEST_CASE("probes are of stress or of strain") {
  const std::string head = "name = 'x'\naction = 'probes'\n";
  const auto stage = read_grain_stage(TomlTable::parse(head + "norm_strain = 2e-5\n", "s"));
  const auto& probes = std::get<GrainProbeStage>(stage.work);
  CHECK(probes.probing.kind == sim::ProbeKind::strain);
  CHECK(probes.probing.norm_strain == 2e-5);
  for (const std::string keys : {"norm_strain = 0\n", "norm_strain = 1\n",
                                 "norm_kPa = 1\nnorm_strain = 1e-5\n", "ramp_steps = 1\n"})
    CHECK_THROWS_AS(read_grain_stage(TomlTable::parse(head + keys, "s")), BadInput);
}

TEST_CASE("extension is a negative strain rate with a stress ratio below 0 to end at") {
  const auto stage = read_grain_stage(TomlTable::parse(
      "name = 'x'\naction = 'drained'\nradial_stress_kPa = 50\nstrain_rate_per_s = -0.1\n"
      "end_axial_strain_pct = 3\nend_stress_ratio = -0.2\n",
      "s"));
  const auto& path = std::get<GrainPathStage>(stage.work).path;
  CHECK(path.strain_rate_per_s == -0.1);
  CHECK(path.stress_ratio == -0.2);
  CHECK(path.pressure_pa == 50e3);
}

TEST_CASE("axis 1 of a path goes by strain or by load") {
  const std::string head = "name = 'x'\naction = 'undrained'\nend_axial_strain_pct = 3\n";
  const auto stage = read_grain_stage(TomlTable::parse(head + "load_rate_kPa_per_s = -20\n", "s"));
  CHECK(std::get<GrainPathStage>(stage.work).path.load_rate_pa_per_s == -20e3);
  for (const std::string keys :
       {"", "load_rate_kPa_per_s = 0\n", "load_rate_kPa_per_s = 1\nstrain_rate_per_s = 1\n"})
    CHECK_THROWS_AS(read_grain_stage(TomlTable::parse(head + keys, "s")), BadInput);
}
