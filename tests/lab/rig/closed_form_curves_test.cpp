// SPDX-License-Identifier: GPL-3.0-or-later
// Curves in closed form, written by a program that knows nothing of triax (curves/make_curves.py
// has the equations): read, reduced and judged as a record is, against what the equations say.
#include <catch2/catch.hpp>
#include <cmath>

#include "lab/rig/recorded.hpp"
#include "lab/rig/session.hpp"

using namespace triax::lab;

namespace {

constexpr double kM = 1.25, kA = 0.006, kC = 0.005, kStep = 0.0004;

TestSummary replay_curve(const std::string& name) {
  const auto rig = open_record("tests/lab/rig/curves/" + name, {});
  return run_session(*rig, {});
}

/// Onset where dq/dε₁ = 0: at ε₁ = c, at most one row (0.04 %) later, with q = s c/e and η = M c/(c
/// + a).
void check_flow(const TestSummary& s, double p0_pa) {
  REQUIRE(s.collapse.kind == CollapseKind::flow);
  const auto& onset = *s.collapse.onset;
  CHECK(*onset.axial_strain == Approx(kC).margin(kStep + 1e-9));
  CHECK(*onset.q_pa == Approx(kM * p0_pa / kA * kC / std::exp(1.0)).epsilon(0.002));
  CHECK(*onset.q_pa / *onset.p_eff_pa == Approx(kM * kC / (kC + kA)).margin(0.0125));
  CHECK_FALSE(s.collapse.inside_limit_surface);  // the record gives no friction angle
  CHECK(s.peak->reading == onset.reading);
}

}  // namespace

TEST_CASE("a closed-form flow without a clock: onset at the analytic peak of q") {
  const TestSummary s = replay_curve("flow.dat");
  CHECK(s.readings == 42);
  check_flow(s, 100e3);
  CHECK_FALSE(s.collapse.onset->time_s);
}

TEST_CASE("the same with a clock: the instant of onset is known, too") {
  const TestSummary s = replay_curve("flow_timed.csv");
  check_flow(s, 200e3);
  CHECK(*s.collapse.onset->time_s == Approx(300).margin(24.1));
}

TEST_CASE("a closed-form loss of strength that comes back is limited") {
  const TestSummary s = replay_curve("limited.dat");
  REQUIRE(s.collapse.kind == CollapseKind::limited);
  CHECK(*s.collapse.onset->axial_strain == Approx(kC).margin(kStep + 1e-9));
  CHECK(*s.peak->axial_strain == Approx(0.05));
}

TEST_CASE("a closed-form curve that always rises is no collapse") {
  CHECK(replay_curve("stable.dat").collapse.kind == CollapseKind::none);
}

TEST_CASE("the table without a clock is read as Karlsruhe's, its stresses agree with each other") {
  const auto rig = open_record("tests/lab/rig/curves/flow.dat", {});
  CHECK(rig->header().dialect == "karlsruhe");
  CHECK_FALSE(rig->header().has_time);
  CHECK(rig->header().stages.at(0).drainage == Drainage::closed);
  Reading reading;
  int rows = 0;
  while (rig->next(reading)) {
    using enum Quantity;
    const double axial = reading[effective_axial_stress], radial = reading[effective_radial_stress];
    CHECK(axial - radial == Approx(reading[deviator_stress]).margin(2));
    CHECK((axial + 2 * radial) / 3 == Approx(reading[mean_effective_stress]).margin(2));
    CHECK(600e3 - radial == Approx(reading[pore_pressure]).margin(2));
    ++rows;
  }
  CHECK(rows == 42);
}
