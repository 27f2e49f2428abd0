// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/src/sample_tests.hpp"

#include <algorithm>
#include <cmath>

#include "sim/mechanics/axisymmetric.hpp"

namespace triax::src::test {
namespace {

lab::State state(std::int64_t reading, bool with_time, double strain, double q_pa, double p_pa) {
  lab::State s;
  s.reading = reading;
  if (with_time) s.time_s = 0.1 * static_cast<double>(reading);
  s.strain = {strain, -strain / 2};
  s.volumetric_strain = 0;
  s.q = q_pa;
  s.p_eff = p_pa;
  s.effective_stress = {p_pa + 2 * q_pa / 3, p_pa - q_pa / 3};
  s.pore_pressure = with_time ? 300e3 + 140e3 - p_pa + q_pa / 3 : lab::kMissing;
  return s;
}

lab::SecondOrderWorkPoint work(std::int64_t reading, bool with_time, double normalised) {
  lab::SecondOrderWorkPoint point;
  point.reading = reading;
  point.time_s = with_time ? 0.1 * static_cast<double>(reading) : lab::kMissing;
  point.work.normalised = normalised;
  point.normalised_error = 0.05;
  point.window_readings = 31;
  return point;
}

}  // namespace

TestResult flow_test() {
  TestResult test;
  for (std::int64_t i = 0; i <= 900; ++i) {
    const double x = static_cast<double>(i) / 300.0;
    const double strain = i <= 300 ? 0.005 * x * x : 0.005 + 0.05 * (x - 1);
    const double q = i <= 300 ? 60e3 * (1 - (1 - x) * (1 - x)) : 60e3 * std::pow(10, -(x - 1) / 2);
    const double p = i <= 300 ? 140e3 - 40e3 * x * x : 10e3 + 90e3 * std::pow(20, -(x - 1) / 2);
    test.curves.states.push_back(state(i, true, strain, q, p));
    if (i >= 15 && i <= 885)
      test.curves.work.push_back(work(i, true, std::clamp(0.6 * (1 - x * x), -0.8, 0.6)));
  }
  auto& stored = test.stored;
  stored.id = 3;
  stored.status = db::TestStatus::complete;
  stored.stored_at = "2026-01-02T03:04:05Z";
  stored.header.name = "L<oose> 1";
  stored.header.programme = "ICU";
  stored.header.source = "records/loose 1.csv";
  stored.header.dialect = "triax";
  stored.header.specimen.height_m = 0.14;
  stored.header.specimen.diameter_m = 0.07;
  stored.header.specimen.void_ratio = 1.1;
  stored.header.stages = {
      {1, "shear", lab::StageRole::shear, lab::Drainage::closed, lab::AxialControl::displacement}};
  stored.header.warnings = {{12, "missing cell in pore_pressure_kPa"}};
  auto& summary = stored.summary;
  summary.readings = 901;
  summary.consolidation.p_eff_pa = 140e3;
  summary.consolidation.void_ratio = 1.086;
  summary.consolidation.b_value = 0.97;
  const lab::Instant onset{300, 30.0, 0.005, 60e3, 100e3, 360e3};
  summary.peak = onset;
  auto& collapse = summary.collapse;
  collapse.kind = lab::CollapseKind::flow;
  collapse.onset = onset;
  collapse.inside_limit_surface = true;
  collapse.second_order_work_normalised = -0.02;
  collapse.second_order_work_error = 0.01;
  collapse.limit_stress_ratio = 1.25;
  collapse.limit_source = lab::kGivenLimit;
  collapse.criteria = {
      {"second_order_work", true, 301, 30.1, 0.6,
       "negative beyond 3 standard errors for 40 readings"},
      {"loss_of_control", true, 320, 32.0, 0.61, "the axial strain rate grew 12 times"},
      {"control_peak", false, std::nullopt, std::nullopt, std::nullopt, ""}};
  summary.checks = {
      {lab::CheckKind::b_value, 0.97, 0.95, true, "saturated enough"},
      {lab::CheckKind::rate, std::nullopt, std::nullopt, false, "no time in the B check"}};
  summary.warnings = {{12, "missing cell in pore_pressure_kPa"}, {0, "rate not checked"}};
  return test;
}

TestResult simulated_test() {
  auto test = flow_test();
  test.stored.id = 4;
  test.stored.header.name = "sim-26";
  test.stored.header.programme = "CSU";
  test.stored.header.origin = lab::Origin::simulated;
  test.stored.header.source = "programmes/sim_26.toml";
  test.stored.header.dialect.clear();
  test.stored.header.seed = 7;
  auto& onset = *test.stored.summary.collapse.onset;
  onset.q_pa = 110e3;
  onset.p_eff_pa = 200e3;
  test.stored.summary.truth = lab::Truth{true, 29.95, 0.00498, 60e3, 100.2e3, 359.8e3};
  return test;
}

TestResult stable_test() {
  TestResult test;
  for (std::int64_t i = 0; i <= 500; ++i) {
    const double x = static_cast<double>(i) / 500.0;
    test.curves.states.push_back(
        state(i, false, 0.15 * x, 200e3 * std::tanh(4 * x), 100e3 + 60e3 * std::tanh(4 * x)));
    if (i >= 15 && i <= 485) test.curves.work.push_back(work(i, false, 0.7 * (1 - x)));
  }
  test.stored.id = 5;
  test.stored.status = db::TestStatus::complete;
  test.stored.header.name = "stable";
  test.stored.header.has_time = false;
  test.stored.summary.readings = 501;
  test.stored.summary.peak = lab::Instant{500, {}, 0.15, 199.9e3, 159.9e3, {}};
  return test;
}

TestResult interrupted_test() {
  auto test = flow_test();
  test.curves.states.resize(100);
  test.curves.work.clear();
  test.stored.id = 6;
  test.stored.status = db::TestStatus::interrupted;
  test.stored.header.name = "cut off";
  test.stored.summary = {};
  test.stored.summary.readings = 100;
  return test;
}

}  // namespace triax::src::test
