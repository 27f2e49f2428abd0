// SPDX-License-Identifier: GPL-3.0-or-later
// A runaway that was seen: no rule of health takes it away, for what the axis did is known without
// pore pressure, volume and valve.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/lab/rig/fault_matrix.hpp"

using namespace triax::lab;
using namespace triax::lab::testing;
using Catch::Contains;

namespace {

ShortTest short_test(const std::string& name) {
  for (const ShortTest& test : short_tests())
    if (test.name == name) return test;
  throw std::invalid_argument(name);
}

Outcome with_fault(const std::string& test, const char* device, FaultKind kind, double from_s) {
  return run_with(read_programme(text_of(short_test(test)), "p.toml"),
                  {{device, kind, from_s, {}, 0}});
}

/// A CSU test of specimen and pressures that a laboratory has: with air in the pores, and with a
/// rest at the stress before the valve is shut, after which the volume gauge no longer moves.
Outcome csu_with_air(double p_eff_kPa, double void_ratio, double rest_min,
                     const std::vector<Fault>& faults = {}) {
  std::string text = fmt::format(R"(
[test]
name = "CSU"
type = "CSU"
scan_interval_s = 5.0
[specimen]
material = "inl2/S28-general"
height_mm = 140.0
diameter_mm = 70.0
void_ratio = {}
initial_effective_stress_kPa = {}
saturation = 0.97
[rig]
back_pressure_kPa = 500.0
water_bulk_modulus_GPa = 2.2
system_compliance_mm3_per_kPa = 2.0
drainage_resistance_kPa_s_per_mm3 = 0.5
instruments = "standard"
[rig.frame]
travel_mm = 24.0
)",
                                 void_ratio, p_eff_kPa);
  const auto stage = [&](const std::string& drainage, const std::string& keys,
                         const std::string& end) {
    text += fmt::format(
        "[[stages]]\nname = \"{}\"\nrole = \"shear\"\ndrainage = \"{}\"\ntime_limit_min = 2000\n"
        "{}\nend = [{}]\n",
        end, drainage, keys, end);
  };
  const double q_kPa = 0.58 * p_eff_kPa;
  stage("open", "axial = \"displacement\"\naxial_rate_mm_per_min = 0.05",
        fmt::format("{{quantity = 'q_kPa', above = {}}}", q_kPa));
  if (rest_min > 0)
    stage("open", "axial = \"constant_q\"",
          fmt::format("{{quantity = 'time_min', above = {}}}", rest_min));
  stage("closed",
        fmt::format("axial = \"constant_q\"\naveraging_s = 5.0\ncell_rate_kPa_per_min = {}",
                    -p_eff_kPa / 150),
        "{quantity = 'axial_strain_pct', above = 15.0}");
  return run_with(read_programme(text, "csu.toml"), faults);
}

}  // namespace

TEST_CASE(
    "CSU with air in the pores: u rests until the specimen collapses, and the valve is shut") {
  struct At {
    double p_eff_kPa, void_ratio;
  };
  for (const At& at : {At{100, 1.10}, At{300, 1.08}, At{500, 1.08}, At{750, 1.08}})
    for (const double rest_min : {0.0, 30.0}) {
      const Outcome out = csu_with_air(at.p_eff_kPa, at.void_ratio, rest_min);
      INFO(at.p_eff_kPa << " kPa, rest of " << rest_min << " min\n" << out.said());
      const Collapse& v = out.summary.collapse;
      const Truth& truth = *out.summary.truth;
      REQUIRE(truth.lost_sustainability);
      CHECK(truth.run_aways.back().end == RunAwayEnd::end_of_travel);
      REQUIRE(v.kind == CollapseKind::flow);
      CHECK_FALSE(v.judged_until);
      CHECK(*v.onset->eta() == Approx(*truth.q_pa / *truth.p_eff_pa).margin(0.02));
    }
}

TEST_CASE("under load a specimen that fell did so although the pore pressure is dead") {
  for (const FaultKind kind : {FaultKind::stuck, FaultKind::drop_out, FaultKind::open_circuit}) {
    const Outcome out = with_fault("loose, by load", "pore_pressure", kind, 120);
    const Collapse& v = out.summary.collapse;
    INFO(to_string(kind) << '\n' << out.said());
    REQUIRE(v.kind == CollapseKind::flow);
    CHECK(*v.onset->time_s == Approx(out.summary.truth->run_aways.back().start_s).margin(1));
    CHECK(*v.onset->q_pa == Approx(*out.summary.truth->q_pa).margin(1e3));
    CHECK_FALSE(v.onset->eta());
    CHECK_FALSE(v.inside_limit_surface);
    CHECK(v.judged_until < v.onset->reading);
    CHECK_THAT(v.judged_until_reason, Contains("pore_pressure"));
    for (const Criterion& one : v.criteria)
      CHECK(one.detected == (one.name == "loss_of_control" ? std::optional(true) : std::nullopt));
  }
}

TEST_CASE("at held q a specimen that fell did so although the valve is open") {
  const Outcome out = csu_with_air(300, 1.08, 30, {{"valve", FaultKind::does_not_close, 0, {}, 0}});
  const Collapse& v = out.summary.collapse;
  INFO(out.said());
  REQUIRE(out.summary.truth->run_aways.back().end == RunAwayEnd::end_of_travel);
  CHECK_THAT(out.said(), Contains("water flows although the valve is closed"));
  REQUIRE(v.kind == CollapseKind::flow);
  REQUIRE(v.loss_of_control);
  CHECK(*v.loss_of_control->time_s ==
        Approx(out.summary.truth->run_aways.back().start_s).margin(5));
  CAPTURE(*out.summary.truth->time_s, *v.onset->time_s);
  CHECK(*v.onset->time_s == Approx(*out.summary.truth->time_s).margin(30));
  CHECK(v.judged_until < v.loss_of_control->reading);
}

TEST_CASE("what a servo does with a dead load cell is no fall of the specimen") {
  const Outcome out = with_fault("loose, by load", "axial_force", FaultKind::stuck, 120);
  CHECK_FALSE(out.summary.collapse.detected());
}
