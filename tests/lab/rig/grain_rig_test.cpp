// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of grains in the apparatus, from the file of a state to the verdict.
#include <catch2/catch.hpp>
#include <cmath>

#include "lab/records/record_writer.hpp"
#include "lab/rig/recorded.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"
#include "tests/lab/grains/grain_files.hpp"
#include "tests/lab/rig/rig_text.hpp"

using namespace triax::lab;
using namespace triax::lab::test;

namespace {

constexpr double kLoose = 0.5235988, kDense = 0.0872665;  // friction of compaction, rad

/// Consolidated to 110 kPa, with the instruments of a good laboratory.
Programme grain_programme(const GrainFolder& folder, const std::string& grains,
                          const std::string& shear) {
  return read_programme(
      "[test]\nname = \"grains\"\ntype = \"ICU\"\nseed = 3\nscan_interval_s = 0.5\n[specimen]\n"
      "grains = \"" +
          grains +
          "\"\nheight_mm = 140.0\ndiameter_mm = 70.0\nlimit_friction_angle_deg = 24.0\n[rig]\n"
          "back_pressure_kPa = 300.0\nwater_bulk_modulus_GPa = 2.2\n"
          "system_compliance_mm3_per_kPa = 0.5\ndrainage_resistance_kPa_s_per_mm3 = 0.1\n"
          "instruments = \"standard\"\n[rig.frame]\ntravel_mm = 24.0\n" +
          stage_text("consolidation", "open", "free",
                     "cell_rate_kPa_per_min = 60.0\ncell_target_kPa = 410.0",
                     "\"cell_pressure_kPa\", above = 410.0") +
          stage_text("consolidation", "open", "free", "", "\"time_min\", above = 0.5") + shear,
      folder / "p.toml");
}

}  // namespace

TEST_CASE("loose grains flow in an undrained test, as the verdict and the truth have it",
          "[slow]") {
  const GrainFolder folder;
  folder.make("loose.grains", kLoose);
  const Programme programme = grain_programme(
      folder, "loose.grains",
      shear_stage("closed", "displacement", "axial_rate_mm_per_min = 1.5\ntime_limit_min = 60.0",
                  "\"axial_strain_pct\", above = 2.0"));
  VirtualRig rig(programme);
  CHECK(rig.header().specimen.material == "500 spheres, loose.grains");
  CHECK(rig.header().origin == Origin::simulated);
  RecordWriter writer(folder / "loose.csv", rig.header());
  const SessionListener to_record = {
      .scanned = [&](const Reading& reading, const State&) { writer.write(reading); }};
  const TestSummary summary = run_session(rig, {}, {to_record});
  const auto truth = rig.truth();
  writer.finish(rig.header(), truth);
  CHECK(summary.collapse.kind == CollapseKind::flow);
  REQUIRE(summary.collapse.onset);
  REQUIRE(truth);
  REQUIRE(truth->lost_sustainability);
  CHECK(*truth->axial_strain < 0.015);
  CHECK(rig.specimen_state().material.p() < 20e3);

  const auto record = open_record(folder / "loose.csv", {});
  const TestSummary replayed = run_session(*record, {});
  CHECK(replayed.collapse.kind == CollapseKind::flow);
  REQUIRE(replayed.collapse.onset);
  CHECK(replayed.collapse.onset->eta() == summary.collapse.onset->eta());
}

TEST_CASE("dense grains do not flow in a drained test, and hold the cell pressure") {
  const GrainFolder folder;
  folder.make("dense.grains", kDense);
  VirtualRig rig(grain_programme(
      folder, "dense.grains",
      shear_stage("open", "displacement", "axial_rate_mm_per_min = 1.5\ntime_limit_min = 60.0",
                  "\"axial_strain_pct\", above = 1.0")));
  const TestSummary summary = run_session(rig, {});
  CHECK(summary.collapse.kind != CollapseKind::flow);
  const auto& state = rig.specimen_state();
  CHECK(state.cell_pressure - state.pore_pressure == Approx(110e3).margin(8e3));
  CHECK(state.material.q() > 100e3);
}
