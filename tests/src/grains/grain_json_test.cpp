// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_json.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/src/sample_grains.hpp"

using namespace triax;
using nlohmann::json;

namespace {

json document() { return json::parse(src::grain_json(src::test::sample_run())); }

}  // namespace

TEST_CASE("the document says what it is and what was made") {
  const json d = document();
  CHECK(d["origin"] == "simulated");
  CHECK(d["format"] == src::kGrainReportFormat);
  CHECK(d["version"] == src::kGrainReportVersion);
  CHECK(d["programme"]["name"] == "sample");
  const json& g = d["specimen"];
  CHECK(g["grains"] == 4);
  CHECK(g["seed"] == 7);
  CHECK(g["law"]["kn_over_ds_MPa"] == 356.0);
  CHECK(g["law"]["kn_over_ds_reading"] == "in_series");
  CHECK(g["law"]["friction_deg"].get<double>() == Approx(35));
  CHECK(g["compaction_friction_deg"].get<double>() == Approx(14));
  CHECK(g["porosity_wanted"].is_null());
  CHECK(g["state"]["floating_grains"] == 4);
  CHECK(g["state"]["grains_outside"] == 0);
  CHECK(d["stages"].size() == 9);
}

TEST_CASE("a path holds all points, its peaks and its marks") {
  const json path = document()["stages"][2];
  CHECK(path["name"] == "R-0.8");
  CHECK(path["from"].is_null());
  CHECK(path["R"] == 0.8);
  CHECK(path["end"] == "collapse");
  REQUIRE(path["points"].size() == 41);
  CHECK(path["points"][0]["w2_J_per_m3"].is_null());
  CHECK(path["points"][1]["w2_J_per_m3"].get<double>() == Approx(0.1));
  CHECK(path["points"][21]["w2_J_per_m3"].get<double>() == Approx(-0.05));
  CHECK(path["peak_path_stress"]["path_stress_kPa"].get<double>() == Approx(20));
  CHECK(path["peak_path_stress"]["fell"] == true);
  CHECK(path["w2_first_negative"]["point"] == 22);
  CHECK(path["kinetic_energy_most_J"] == 3e-4);
  CHECK(path["marks"][0]["at"]["strain"]["axial"].get<double>() == Approx(0.001));
  CHECK(path["marks"][1]["at"].is_null());
  CHECK(document()["stages"][1]["R"].is_null());  // drained
}

TEST_CASE("a rose holds its probes, the null probe and the ranges") {
  const json rose = document()["stages"][5];
  REQUIRE(rose["probes"].size() == 36);
  const json& probe = rose["probes"][9];
  CHECK(probe["alpha_deg"].get<double>() == Approx(90));
  CHECK(probe["strain"]["axial"].get<double>() == Approx(1e-5));
  CHECK(probe["w2_J_per_m3"]["lagrangian"].get<double>() == Approx(0.01));
  CHECK(probe["w2_J_per_m3"]["eulerian"].get<double>() == Approx(0.01));
  CHECK(probe["micro_over_macro"].get<double>() == Approx(1.2));
  CHECK(probe["non_permanent_share"].get<double>() == Approx(1e-3));
  CHECK(rose["null_probe"]["alpha_deg"].is_null());
  CHECK(rose["null_probe"]["micro_over_macro"].is_null());
  CHECK(rose["null_probe_over_smallest"].get<double>() == Approx(1e-3));
  CHECK(rose["negative_w2"][0]["from_deg"].get<double>() == Approx(220));
  CHECK(rose["agreement"]["ranges"][0]["to_deg"].get<double>() == Approx(420));
  CHECK(rose["at_rest"] == 35);
}

TEST_CASE("a perturbation and a rest tell how they ended") {
  const json d = document();
  CHECK(d["stages"][4]["held"] == "stresses");
  CHECK(d["stages"][4]["path_stress_kPa"] == 12.5);
  const json& energy = d["stages"][8];
  CHECK(energy["end"] == "collapsed");
  CHECK(energy["chi"].get<double>() == Approx(0.05));
  CHECK(energy["kinetic_energy_given_J"] == 1e-4);
  CHECK(energy["grains_hit"] == 40);
  CHECK(energy["points"].size() == 11);
}

TEST_CASE("what is unknown is null: no specimen yet, a stopped probe, a value that is no number") {
  lab::GrainReport report{"sample", "sample.toml", {}, {}};
  CHECK(json::parse(src::grain_json(report))["specimen"].is_null());
  report = src::test::sample_run();
  auto& rose = std::get<lab::ReportedGrainRose>(report.stages[5].came).made.rose;
  rose.probes[0].stopped = true;
  rose.probes[1].strain.axial = std::nan("");
  auto& path = std::get<lab::ReportedGrainPath>(report.stages[2].came);
  path.points[3].p_pa = 0;
  const json d = json::parse(src::grain_json(report));
  CHECK_FALSE(d["stages"][5]["probes"][0].contains("strain"));
  CHECK(d["stages"][5]["probes"][0]["stopped"] == true);
  CHECK(d["stages"][5]["probes"][1]["strain"]["axial"].is_null());
  CHECK(d["stages"][2]["points"][3]["eta"].is_null());
}

TEST_CASE("a rose tells what micro and macro differ by, and where energy went") {
  const json rose = document()["stages"][5];
  CHECK(rose["kind"] == "stress");
  CHECK(rose["norm_strain"].is_null());
  CHECK(rose["gap"]["left_share"].get<double>() == Approx(0.01));
  CHECK(rose["gap"]["boundary_part_most_J_per_m3"].get<double>() == Approx(0.03));
  CHECK(rose["ledger"].is_null());
  const json& probe = rose["probes"][9];
  CHECK(probe["gap_J_per_m3"]["micro_less_macro"].get<double>() == Approx(0.002));
  CHECK(probe["gap_J_per_m3"]["grains_turning"].get<double>() == Approx(0.0018));
  CHECK(probe["gap_J_per_m3"]["left"].get<double>() == Approx(0.00002));
  CHECK(probe["boundary_part_J_per_m3"].get<double>() == Approx(-0.03));
  CHECK(probe["ledger"]["friction_J"] == 9e-7);
  CHECK(probe["ledger"]["error_share"].get<double>() == Approx(5e-3));
  CHECK(probe["ledger"]["momentum_kg_m_per_s"]["walls"].size() == 3);
  CHECK(document()["stages"][1]["ledger"]["walls_J"] == 2e-6);
}

TEST_CASE("probes by strain have a norm of strain and none of stress") {
  lab::GrainReport report = src::test::sample_run();
  auto& made = std::get<lab::ReportedGrainRose>(report.stages[5].came);
  made.kind = sim::ProbeKind::strain;
  made.norm_strain = 1e-5;
  made.made.rose.probes[0].norm_strain = 1e-5;
  const json rose = json::parse(src::grain_json(report))["stages"][5];
  CHECK(rose["kind"] == "strain");
  CHECK(rose["norm_kPa"].is_null());
  CHECK(rose["norm_strain"] == 1e-5);
  CHECK(rose["probes"][0]["norm_kPa"].is_null());
  CHECK(rose["probes"][0]["norm_strain"] == 1e-5);
}
