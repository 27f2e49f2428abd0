// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of tests that laboratories make, from a table to its assessment. Curves are closed forms.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "lab/base/bad_input.hpp"
#include "lab/rig/recorded.hpp"
#include "lab/rig/session.hpp"

using namespace triax::lab;
using Catch::Contains;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

struct Replayed {
  RecordHeader header;
  TestSummary summary;
};

Replayed replayed(const std::string& text, const Sets& sets = {}) {
  RecordOptions options;
  options.sets = sets;
  const auto rig = open_record(open_memory("m.csv", text), options);
  TestSummary summary = run_session(*rig, {});
  return {rig->header(), std::move(summary)};
}

std::string all_warnings(const TestSummary& summary) {
  std::string text;
  for (const Warning& warning : summary.warnings) text += warning.text + "\n";
  return text;
}

/// q grows to 180 kPa at 6 % axial strain and falls towards 150 kPa.
double softening(double strain_pct) {
  if (strain_pct <= 6) return 200 * strain_pct / (strain_pct + 2.0 / 3);
  return 150 + 30 * std::exp(-(strain_pct - 6) / 2);
}

/// Axial strain (%), q and p' with σ₃' = 100 kPa to 18 %.
std::string drained_table() {
  std::string text = "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n";
  for (int i = 0; i <= 36; ++i) {
    const double q = softening(0.5 * i);
    text += fmt::format("{:.2f},{:.3f},{:.3f}\n", 0.5 * i, q, 100 + q / 3);
  }
  return text;
}

/// A stiff clay at 50 kPa: σ₃' falls to 14 kPa, q peaks at 125 kPa and falls to 110 kPa.
std::string stiff_clay(const std::string& preamble = "") {
  std::string text =
      preamble + "axial_strain_pct,deviator_stress_kPa,effective_radial_stress_kPa\n";
  for (int i = 0; i <= 40; ++i) {
    const double x = 0.1 * i;
    const double rising = 145 * x / (x + 0.32);
    const double q = x <= 2 ? rising : 110 + 15 * std::exp(-(x - 2) / 0.5);
    text += fmt::format("{:.2f},{:.2f},{:.2f}\n", x, q, 12 + 38 * std::exp(-x / 0.55));
  }
  return text;
}

constexpr double kArea_m2 = std::numbers::pi / 4 * 0.038 * 0.038;

/// q = 176 kPa at its peak of 10.5 % axial strain, of a specimen of 76 × 38 mm.
double quick(double strain) { return 176 * (1 - std::pow(strain / 0.105 - 1, 2)); }

std::string raw_total(const std::string& headings, const std::string& rest,
                      const std::string& preamble = "") {
  std::string text = preamble + headings + "\n";
  for (int i = 0; i <= 31; ++i) {
    const double strain = 5e-3 * i;
    text += fmt::format("{},{:.3f},{:.3f}{}\n", 30 * i,
                        quick(strain) * kArea_m2 * 1e3 / (1 - strain), 76 * strain, rest);
  }
  return text;
}

std::string reduced_total(const std::string& heading, double more) {
  std::string text = "axial_strain_pct," + heading + "\n";
  for (int i = 0; i <= 31; ++i)
    text += fmt::format("{:.2f},{:.3f}\n", 0.5 * i, quick(5e-3 * i) + more);
  return text;
}

const Sets kDimensions{{"specimen.height_mm", "76"}, {"specimen.diameter_mm", "38"}};

Sets with(Sets sets, const std::string& key, const std::string& value) {
  sets.emplace_back(key, value);
  return sets;
}

void check_c_u(const TestSummary& summary) {
  REQUIRE(summary.undrained_strength);
  CHECK(summary.undrained_strength->c_u_pa() / 1e3 == Approx(88).margin(0.05));
  CHECK(*summary.undrained_strength->at.axial_strain == Approx(0.105).margin(1e-5));
  REQUIRE(summary.peak);
  CHECK(*summary.peak->q_pa / 1e3 == Approx(176).margin(0.1));
  CHECK_FALSE(summary.collapse.judged);
  CHECK_THAT(summary.collapse.judged_until_reason, Contains("total stresses"));
  for (const Criterion& one : summary.collapse.criteria) {
    CHECK_FALSE(one.detected);
    CHECK_THAT(one.evidence, Contains("total stresses") && !Contains("complete states"));
  }
}

}  // namespace

TEST_CASE("Drained table: softening at the peak is a failure, for every type", "[kinds]") {
  for (const char* type : {"CIDC", "CADC", "CD", "CID", ""}) {
    const auto [header, s] = replayed(drained_table(), {{"test.programme", type}});
    INFO(type);
    CHECK(header.stages.front().drainage == Drainage::open);
    CHECK(s.collapse.judged);
    CHECK(s.collapse.kind == CollapseKind::none);
    REQUIRE(s.collapse.onset);
    CHECK(*s.collapse.onset->q_pa / 1e3 == Approx(180).margin(5));
    CHECK(*s.collapse.strength_lost > 0.1);
    CHECK(all_warnings(s).find("but σ₃′") == std::string::npos);
  }
}

TEST_CASE("Drained table: a type that contradicts the readings is reported", "[kinds]") {
  for (const char* type : {"CIUC", "CAUC", "CK0U"}) {
    const auto [header, s] = replayed(drained_table(), {{"test.programme", type}});
    CHECK(header.stages.front().drainage == Drainage::open);
    CHECK(s.collapse.kind == CollapseKind::none);
    CHECK_THAT(all_warnings(s), Contains(std::string("type ") + type + " is undrained, but σ₃′") &&
                                    Contains("--set stages.1.drainage=closed"));
  }
  const auto said = replayed(drained_table(), {{"stages.1.drainage", "closed"}});
  CHECK(said.header.stages.front().drainage == Drainage::closed);
}

TEST_CASE("Drained table: where the volume is needed, that is the reason", "[kinds]") {
  std::string text = "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n";
  for (int i = 0; i <= 36; ++i)  // σ₃' falls from 100 to 40 kPa while q grows
    text += fmt::format("{},{},{:.3f}\n", 0.5 * i, 2 * i, 100 - 60.0 * i / 36 + 2.0 * i / 3);
  const auto s = replayed(text, {{"test.programme", "CID"}}).summary;
  CHECK_FALSE(s.collapse.judged);
  CHECK_THAT(s.collapse.judged_until_reason, Contains("no volumetric strain"));
  for (const Criterion& one : s.collapse.criteria)
    CHECK(one.evidence.find("complete states") == std::string::npos);
}

TEST_CASE("UU and UC: c_u from raw channels", "[kinds]") {
  const std::string columns = "time_s,axial_force_N,axial_displacement_mm";
  check_c_u(replayed(raw_total(columns + ",cell_pressure_kPa", ",200"),
                     with(kDimensions, "test.programme", "UU"))
                .summary);
  const auto held = replayed(raw_total(columns, ""), with(with(kDimensions, "test.programme", "UU"),
                                                          "test.cell_pressure_bar", "2"));
  check_c_u(held.summary);
  CHECK(held.header.has(Quantity::cell_pressure));
  for (const char* type : {"UC", "UNC", "UCS"}) {
    const auto free = replayed(raw_total(columns, ""), with(kDimensions, "test.programme", type));
    check_c_u(free.summary);
    CHECK_THAT(all_warnings(free.summary), Contains("assumed to be 0 kPa"));
  }
}

TEST_CASE("UU: a negative q is reported, as extension or another sign", "[kinds]") {
  const auto c_u_of = [](int sign) {
    std::string text = "axial_displacement_mm,axial_force_N,cell_pressure_kPa\n";
    for (int i = 0; i <= 30; ++i)
      text += fmt::format("{:.2f},{:.1f},200\n", sign * 0.5 * i, sign * 150 * std::tanh(0.2 * i));
    return replayed(text, with(kDimensions, "test.programme", "UU")).summary;
  };
  CHECK_THAT(all_warnings(c_u_of(-1)), Contains("write sign = -1"));
  CHECK(all_warnings(c_u_of(1)).find("sign = -1") == std::string::npos);
}

TEST_CASE("UU and UC: c_u from reduced tables", "[kinds]") {
  for (const char* type : {"UU", "UC"})
    check_c_u(
        replayed(reduced_total("deviator_stress_kPa", 0), {{"test.programme", type}}).summary);
  check_c_u(replayed(reduced_total("axial_stress_kPa", 0), {{"test.programme", "UNC"}}).summary);
  check_c_u(replayed(reduced_total("axial_stress_kPa", 150),
                     {{"test.programme", "UU"}, {"test.cell_pressure_kPa", "150"}})
                .summary);
}

TEST_CASE("UU with a pore pressure: total stresses all the same", "[kinds]") {
  check_c_u(replayed(raw_total("time_s,axial_force_N,axial_displacement_mm,cell_pressure_kPa,"
                               "pore_pressure_kPa",
                               ",200,20"),
                     with(kDimensions, "test.programme", "UU"))
                .summary);
}

TEST_CASE("RecordedRig: what is missing in total stresses, and how to give it", "[kinds]") {
  const std::string columns = "time_s,axial_force_N,axial_displacement_mm";
  CHECK_THROWS_WITH(
      replayed(raw_total(columns, ""), with(kDimensions, "test.programme", "UU")),
      Contains("also needs cell_pressure_kPa") && Contains("--set test.cell_pressure_kPa=..."));
  CHECK_THROWS_WITH(replayed(reduced_total("deviator_stress_kPa", 0)),
                    Contains("--set test.programme=UU, or UC"));
  CHECK_THROWS_WITH(replayed(raw_total(columns, ""), {{"test.cell_pressure_kPa", "-5"}}),
                    Contains("out of range"));
  const auto twice =
      replayed(raw_total(columns + ",cell_pressure_kPa", ",200"),
               with(with(kDimensions, "test.programme", "UU"), "test.cell_pressure_kPa", "300"));
  CHECK_THAT(all_warnings(twice.summary), Contains("is not used"));
}

TEST_CASE("RecordedRig: a held cell pressure serves an undrained test too", "[kinds]") {
  std::string text = "time_s,axial_force_N,axial_displacement_mm,pore_pressure_kPa\n";
  for (int i = 0; i <= 60; ++i)
    text += fmt::format("{},{:.3f},{:.3f},{:.2f}\n", 10 * i, 2e3 * kArea_m2 * i, 0.05 * i,
                        100 + 0.5 * i);
  const auto [header, s] = replayed(text, with(kDimensions, "test.cell_pressure_kPa", "200"));
  CHECK(header.stages.front().drainage == Drainage::closed);
  CHECK(*s.consolidation.p_eff_pa == Approx(100e3));
  CHECK(s.collapse.judged);
  CHECK_FALSE(s.undrained_strength);
}

TEST_CASE("Stiff clay: without c' a steep ratio is not judged, and cohesion is named", "[kinds]") {
  const auto s = replayed(stiff_clay()).summary;
  CHECK_FALSE(s.collapse.detected());
  CHECK_FALSE(s.collapse.judged);
  CHECK_THAT(s.collapse.judged_until_reason, Contains("specimen.cohesion_kPa"));
  CHECK_THAT(all_warnings(s), Contains("over-consolidated clay") && !Contains("unit is wrong"));
}

TEST_CASE("Stiff clay: softening on c', φ' is a failure", "[kinds]") {
  const Sets sets{{"specimen.cohesion_kPa", "20"}, {"specimen.limit_friction_angle_deg", "35"}};
  const auto s = replayed(stiff_clay(), sets).summary;
  CHECK(s.collapse.judged);
  CHECK(s.collapse.kind == CollapseKind::none);
  CHECK(s.collapse.inside_limit_surface == false);
  CHECK(s.collapse.limit_source == kGivenLimitWithCohesion);
  const auto written =
      replayed(stiff_clay("# [specimen]\n# cohesion_kPa = 20\n# limit_friction_angle_deg = 35\n"));
  CHECK(written.summary.collapse.inside_limit_surface == false);
  const auto strong = replayed(stiff_clay(), {{"specimen.cohesion_kPa", "200"},
                                              {"specimen.limit_friction_angle_deg", "35"}});
  CHECK(strong.summary.collapse.inside_limit_surface == true);
}

TEST_CASE("Rock: q/p' near 3 is cohesion, no wrong unit", "[kinds]") {
  std::string text = "axial_strain_pct,deviator_stress_MPa,effective_radial_stress_MPa\n";
  for (int i = 0; i <= 30; ++i) {
    const double q = i <= 20 ? 5.0 * i : 100 - 6.0 * (i - 20);
    text += fmt::format("{:.2f},{:.2f},2\n", 0.05 * i, q);
  }
  const auto s = replayed(text).summary;
  CHECK_FALSE(s.collapse.detected());
  CHECK_FALSE(s.collapse.judged);
  CHECK_THAT(s.collapse.judged_until_reason, Contains("cohesion") && !Contains("unit"));
  const auto given = replayed(
      text, {{"specimen.cohesion_MPa", "20"}, {"specimen.limit_friction_angle_deg", "45"}});
  CHECK(given.summary.collapse.judged);
  CHECK(given.summary.collapse.kind == CollapseKind::none);
}

TEST_CASE("Below zero: nothing is judged from there on", "[kinds]") {
  const auto last_judged = [](const std::string& headings, const auto& row) {
    std::string text = headings + "\n";
    for (int i = 0; i <= 60; ++i) text += row(i, i <= 30 ? 100.0 : 100 - 8.0 * (i - 30)) + "\n";
    const auto s = replayed(text, kDimensions).summary;
    CHECK_FALSE(s.collapse.judged);
    CHECK_FALSE(s.collapse.detected());
    CHECK_THAT(s.collapse.judged_until_reason, Contains("below zero"));
    return s.collapse.judged_until.value_or(-1);
  };
  const auto by_radial = last_judged(
      "axial_strain_pct,deviator_stress_kPa,effective_radial_stress_kPa", [](int i, double radial) {
        return fmt::format("{:.3f},{:.2f},{:.2f}", 0.1 * i, 1.0 * i, radial);
      });
  CHECK(by_radial >= 40);
  CHECK(by_radial <= 43);
  const auto by_p = last_judged(
      "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa", [](int i, double radial) {
        return fmt::format("{:.3f},{:.2f},{:.2f}", -0.1 * i, -0.5 * i, radial - i / 6.0);
      });
  CHECK(by_p <= 43);
  const auto raw_test = last_judged(
      "axial_displacement_mm,axial_force_N,cell_pressure_kPa,pore_pressure_kPa",
      [](int i, double radial) {
        return fmt::format("{:.3f},{:.3f},{:.2f},200", 0.05 * i, 1e3 * kArea_m2 * i, 200 + radial);
      });
  CHECK(raw_test <= 43);
}

TEST_CASE("Digitised curves of 15 to 60 rows are judged", "[kinds]") {
  for (const int rows : {15, 30, 60}) {
    std::string text = "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n";
    for (int i = 0; i < rows; ++i) {  // loose sand, undrained: q falls from 60 to 10 kPa, p' to 12
      const double x = 10.0 * i / (rows - 1);
      const double q = x <= 1 ? 60 * x * (2 - x) : 10 + 50 * std::exp(-(x - 1) / 1.5);
      const double p = 12 + 88 * std::exp(-x / 1.2);
      text += fmt::format("{:.3f},{:.2f},{:.2f}\n", x, q, p);
    }
    INFO(rows);
    const auto s = replayed(text, {{"test.programme", "CIUC"}}).summary;
    CHECK(s.collapse.kind == CollapseKind::flow);
  }
}
