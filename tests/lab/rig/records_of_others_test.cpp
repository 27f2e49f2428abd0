// SPDX-License-Identifier: GPL-3.0-or-later
// Real records of others, in the folder that TRIAX_RECORDS_OF_OTHERS names. They are not ours to
// copy, so without that variable these tests are skipped; closed_form_curves_test.cpp stands for
// them then.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "lab/rig/recorded.hpp"
#include "lab/rig/session.hpp"
#include "tests/lab/rig/rig_text.hpp"

using namespace triax::lab;
using enum Quantity;
using triax::lab::test::all_readings;

namespace {

// The record, or nothing where no folder is named. Where one is, a record that is not there fails.
std::optional<std::string> record_of_others(const std::string& name) {
  const char* folder = std::getenv("TRIAX_RECORDS_OF_OTHERS");
  if (!folder || !*folder) {
    std::cout << "skipped: TRIAX_RECORDS_OF_OTHERS names no folder with " << name << "\n";
    return std::nullopt;
  }
  const auto path = std::filesystem::path(folder) / name;
  if (!std::filesystem::exists(path))
    FAIL("TRIAX_RECORDS_OF_OTHERS: " << path.string() << " is not there");
  return path.string();
}

bool warns(const RecordHeader& header, std::int64_t line, const std::string& text) {
  return std::ranges::any_of(header.warnings, [&](const Warning& warning) {
    return warning.line == line && warning.text.find(text) != std::string::npos;
  });
}

TestSummary replay_of_others(const std::string& path, RecordOptions options = {}) {
  const auto rig = open_record(path, options);
  return run_session(*rig, {});
}

bool mentions(const std::vector<Warning>& warnings, const std::string& text) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const Warning& w) { return w.text.find(text) != std::string::npos; });
}

}  // namespace

TEST_CASE("Karlsruhe TMU-MT1: flow, onset at the peak of q, limit surface unknown", "[of-others]") {
  const auto path = record_of_others("kfs/TMU-MT1.dat");
  if (!path) return;
  const TestSummary s = replay_of_others(*path);
  REQUIRE(s.collapse.kind == CollapseKind::flow);
  CHECK(std::abs(s.collapse.onset->reading - s.peak->reading) <= 3);
  CHECK(*s.collapse.onset->q_pa / 1e3 == Approx(56.5).margin(0.05));
  CHECK(*s.collapse.onset->axial_strain * 100 == Approx(0.52).margin(0.02));
  CHECK_FALSE(s.collapse.inside_limit_surface);  // no friction angle in the file
  CHECK_FALSE(s.collapse.onset->time_s);
  CHECK(mentions(s.warnings, "axial strain"));
}

TEST_CASE("Karlsruhe TMU-AP2: limited, strength comes back", "[of-others]") {
  const auto path = record_of_others("kfs/TMU-AP2.dat");
  if (!path) return;
  const TestSummary s = replay_of_others(*path);
  REQUIRE(s.collapse.kind == CollapseKind::limited);
  CHECK(*s.collapse.onset->q_pa / 1e3 == Approx(136.8).margin(0.05));
  // Between the readings at 0.383 % (136.79 kPa) and 0.434 % (136.62 kPa), nearer to the first.
  CHECK(*s.collapse.onset->axial_strain * 100 == Approx(0.395).margin(0.012));
}

TEST_CASE("Karlsruhe TMU-MT2 and TMD3: no collapse", "[of-others]") {
  for (const char* name : {"kfs/TMU-MT2.dat", "kfs/TMD3.dat"}) {
    const auto path = record_of_others(name);
    if (!path) return;
    CHECK(replay_of_others(*path).collapse.kind == CollapseKind::none);
  }
}

TEST_CASE("Nerlerk G101 flows, G107 does not", "[of-others]") {
  const auto flows = record_of_others("nerlerk/Nerlerk270_CIU_G101.csv");
  const auto holds = record_of_others("nerlerk/Nerlerk270_CIU_G107.csv");
  if (!flows || !holds) return;
  const TestSummary s = replay_of_others(*flows);
  REQUIRE(s.collapse.kind == CollapseKind::flow);
  CHECK(std::abs(s.collapse.onset->reading - s.peak->reading) <= 3);
  CHECK(*s.peak->q_pa / 1e3 == Approx(183).margin(0.5));
  CHECK(*s.consolidation.void_ratio == Approx(0.804));
  CHECK(replay_of_others(*holds).collapse.kind == CollapseKind::none);
}

TEST_CASE("the .gds file: counters joined, B 0.733, its own q 5.4 % too high and the reason said",
          "[of-others]") {
  const auto path = record_of_others("gds/2023-1-2.gds");
  if (!path) return;
  const TestSummary s = replay_of_others(*path);
  CHECK(s.readings == 4501);
  CHECK(*s.consolidation.b_value == Approx(0.733).margin(0.001));
  CHECK(*s.consolidation.height_m * 1e3 == Approx(97.80).margin(0.01));
  const auto closure = std::find_if(s.checks.begin(), s.checks.end(), [](const Check& c) {
    return c.kind == CheckKind::closure_deviator_stress;
  });
  REQUIRE(closure != s.checks.end());
  CHECK(*closure->measured == Approx(-0.055).margin(0.002));
  CHECK_FALSE(closure->ok);
  CHECK(closure->note.find("volume counter was reset") != std::string::npos);
  CHECK(s.collapse.kind == CollapseKind::none);
  CHECK(mentions(s.warnings, "back_volume"));
}

TEST_CASE("the cyclic test runs away in its last readings", "[of-others]") {
  const auto path = record_of_others("cyclic/SJT-07.csv");
  if (!path) return;
  const TestSummary s = replay_of_others(*path);
  CHECK(s.collapse.kind == CollapseKind::flow);
  CHECK(s.collapse.onset->reading > 330);
}

TEST_CASE("the stress-path sheet asks for the specimen and then is reduced", "[of-others]") {
  const auto path = record_of_others("stress_path/Triax-p-q_01__Versuch01.csv");
  if (!path) return;
  CHECK_THROWS_WITH(replay_of_others(*path), Catch::Contains("specimen.height_mm"));
  const TestSummary s = replay_of_others(
      *path, {.sets = {{"specimen.height_mm", "100"}, {"specimen.diameter_mm", "50"}}});
  CHECK(s.readings == 79);
  CHECK(s.collapse.kind == CollapseKind::none);
}

TEST_CASE("GDSLab: five stages, joined counters, the typed-in height", "[of-others]") {
  const auto path = record_of_others("gds/2023-1-2.gds");
  if (!path) return;
  const auto rig = open_record(*path, {});
  const RecordHeader& header = rig->header();
  CHECK(header.dialect == "gdslab");
  CHECK(*header.specimen.height_m == Approx(0.1));
  CHECK(*header.specimen.diameter_m == Approx(0.05));
  CHECK(*header.specimen.specific_gravity == 2.55);
  CHECK(*header.specimen.membrane_thickness_m == Approx(0.4e-3));
  CHECK(*header.specimen.consolidated_height_m == Approx(0.0978).epsilon(1e-6));
  const StageRole roles[] = {StageRole::saturation, StageRole::saturation, StageRole::b_check,
                             StageRole::consolidation, StageRole::shear};
  REQUIRE(header.stages.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) CHECK(header.stages[i].role == roles[i]);
  CHECK(header.stages[4].drainage == Drainage::closed);
  CHECK(header.stages[4].control == AxialControl::displacement);

  const auto readings = all_readings(*rig);
  REQUIRE(readings.size() == 4501);
  for (std::size_t i = 1; i < readings.size(); ++i)
    REQUIRE(readings[i].time_s > readings[i - 1].time_s);
  CHECK(readings.back().time_s == Approx(86100 + 48889));
  const auto first_of_shear =
      std::ranges::find_if(readings, [](const Reading& r) { return r.stage == 5; });
  CHECK((*first_of_shear)[back_volume] == Approx(8058e-9));
  CHECK((*first_of_shear)[axial_displacement] == Approx(2.968e-3));
  CHECK(readings.back()[axial_displacement] == Approx((2.968 + 24.45) * 1e-3));
  CHECK(readings.back()[deviator_stress] == Approx(72.8158e3));
  CHECK(warns(header, 2901, "97.80 mm"));
  CHECK(warns(header, 2901, "back_volume jumps from 8058 to 0 mm3"));
  CHECK(header.back_volume_joined);
  CHECK(warns(header, 42, "stage 2 begins at 300 s"));
}

TEST_CASE("Karlsruhe: undrained and drained tables", "[of-others]") {
  const auto undrained = record_of_others("kfs/TMU-MT1.dat");
  const auto drained = record_of_others("kfs/TMD3.dat");
  if (!undrained || !drained) return;
  const auto rig = open_record(*undrained, {});
  CHECK(rig->header().dialect == "karlsruhe");
  CHECK_FALSE(rig->header().has_time);
  CHECK(rig->header().stages[0].drainage == Drainage::closed);
  const auto readings = all_readings(*rig);
  const auto peak =
      std::ranges::max_element(readings, {}, [](const Reading& r) { return r[deviator_stress]; });
  CHECK((*peak)[deviator_stress] == Approx(56.491e3));
  CHECK((*peak)[axial_strain] == Approx(0.005135));
  CHECK((*peak)[effective_axial_stress] - (*peak)[effective_radial_stress] ==
        Approx((*peak)[deviator_stress]).margin(2));

  const auto other = open_record(*drained, {});
  CHECK(other->header().stages[0].drainage == Drainage::open);
  Reading first;
  REQUIRE(other->next(first));
  CHECK(first[void_ratio] == 0.97513162);
  CHECK(first[mean_effective_stress] == Approx(201.81e3));
}

TEST_CASE("Nerlerk: the columns agree with each other and with p and q", "[of-others]") {
  const auto path = record_of_others("nerlerk/Nerlerk270_CIU_G101.csv");
  if (!path) return;
  const auto rig = open_record(*path, {});
  CHECK(rig->header().name == "CIU_G101");
  CHECK(rig->header().programme == "CIU");
  CHECK(rig->header().specimen.material == "NERLERK SAND");
  CHECK(*rig->header().specimen.void_ratio == 0.883);
  CHECK(*rig->header().specimen.consolidated_void_ratio == 0.804);
  CHECK(rig->header().stages[0].drainage == Drainage::closed);
  for (const Reading& reading : all_readings(*rig)) {
    const double axial = reading[effective_axial_stress];
    const double radial = reading[effective_radial_stress];
    CHECK(reading[deviator_stress] == Approx(axial - radial).margin(1));
    CHECK(reading[mean_effective_stress] == Approx((axial + 2 * radial) / 3).margin(1));
    CHECK(reading[volumetric_strain] == 0);
  }
}

TEST_CASE("cyclic: the last state, with p' below zero, comes through", "[of-others]") {
  const auto path = record_of_others("cyclic/SJT-07.csv");
  if (!path) return;
  const auto rig = open_record(*path, {});
  CHECK(rig->header().dialect == "cyclic");
  CHECK(rig->header().stages[0].control == AxialControl::load);
  const auto readings = all_readings(*rig);
  CHECK(readings.size() == 341);
  CHECK(readings.back()[mean_effective_stress] == Approx(-930).epsilon(1e-6));
  CHECK(readings.back()[axial_strain] == Approx(0.1576684));
}

TEST_CASE("stress path: stages with clocks of their own become one time", "[of-others]") {
  const auto path = record_of_others("stress_path/Triax-p-q_01__Versuch01.csv");
  if (!path) return;
  const auto rig = open_record(*path, {});
  CHECK(rig->header().dialect == "table");
  CHECK(rig->header().is_raw());
  const auto readings = all_readings(*rig);
  REQUIRE(readings.size() == 79);
  for (std::size_t i = 1; i < readings.size(); ++i)
    CHECK(readings[i].time_s > readings[i - 1].time_s);
  CHECK(rig->header().stage(7)->role == StageRole::shear);
  CHECK(rig->header().stage(7)->drainage == Drainage::open);
  CHECK(warns(rig->header(), 84, "78 more, the last in line 162"));
}
