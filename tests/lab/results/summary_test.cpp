// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/summary.hpp"

#include <catch2/catch.hpp>

#include "sim/mechanics/axisymmetric.hpp"

using namespace triax::lab;

TEST_CASE("kinds of collapse read back as what they are called") {
  for (const auto kind : {CollapseKind::none, CollapseKind::limited, CollapseKind::flow})
    CHECK(collapse_kind_from(to_string(kind)) == kind);
  CHECK_FALSE(collapse_kind_from("Flow"));
  Collapse collapse;
  CHECK_FALSE(collapse.detected());
  collapse.kind = CollapseKind::limited;
  CHECK(collapse.detected());
}

// The texts stand in databases and documents of others: they may not change.
TEST_CASE("kinds of events and checks read back as what they are called") {
  for (const char* text :
       {"stage_started", "loss_of_sustainability", "limit_surface", "failure", "sensor_fault",
        "device_fault", "held", "resumed", "aborted", "safe_state", "run_away"}) {
    INFO(text);
    REQUIRE(event_kind_from(text));
    CHECK(to_string(*event_kind_from(text)) == text);
  }
  CHECK_FALSE(event_kind_from("collapse"));
  for (const char* text :
       {"b_value", "consolidation", "zero_difference", "rate", "undrained_volume", "stage_target",
        "closure_deviator_stress", "closure_mean_effective_stress",
        "closure_effective_axial_stress", "closure_effective_radial_stress", "closure_axial_strain",
        "closure_volumetric_strain", "closure_void_ratio", "closure_current_area"}) {
    INFO(text);
    REQUIRE(check_kind_from(text));
    CHECK(to_string(*check_kind_from(text)) == text);
  }
  CHECK_FALSE(check_kind_from("closure_"));
}

TEST_CASE("an instant has a stress ratio and an angle where they exist") {
  Instant instant;
  CHECK_FALSE(instant.eta());
  CHECK_FALSE(instant.phi_mob_rad());
  instant.q_pa = 62e3;
  instant.p_eff_pa = 0;
  CHECK_FALSE(instant.eta());
  instant.p_eff_pa = 100e3;
  CHECK(*instant.eta() == Approx(0.62));
  CHECK(triax::sim::degrees(*instant.phi_mob_rad()) == Approx(16.32).margin(0.01));
  instant.p_eff_pa = 10e3;  // tension in the radial stress: no angle
  CHECK_FALSE(instant.phi_mob_rad());
}

TEST_CASE("Collapse: a loss of control outlives an end, but not that all is unknown", "[results]") {
  Collapse seen;
  seen.loss_of_control = Instant{.reading = 80};
  seen.loss_of_control_detected_at = Moment{82, {}};
  Collapse at_end = seen, withheld = seen, unknown = seen;
  at_end.end_at(60, "a sensor");
  REQUIRE(at_end.loss_of_control);
  CHECK(at_end.loss_of_control_detected_at->reading == 82);
  withheld.withhold("contradiction");
  CHECK_FALSE(withheld.loss_of_control);
  CHECK_FALSE(withheld.loss_of_control_detected_at);
  unknown.end_at({}, "a dead sensor");
  CHECK_FALSE(unknown.loss_of_control);
}

TEST_CASE("of two ends of a judgement the earlier stands, with its reason") {
  Collapse c;
  c.end_at(200, "a loss");
  c.end_at(900, "a sensor");
  CHECK_FALSE(c.judged);
  CHECK(c.judged_until == 200);
  CHECK(c.judged_until_reason == "a loss");
  c.end_at(100, "another sensor");
  CHECK(c.judged_until == 100);
  c.end_at(std::nullopt, "nothing at all");
  CHECK_FALSE(c.judged_until);
  c.end_at(500, "late");
  CHECK(c.judged_until_reason == "nothing at all");
  c.end_at(std::nullopt, "a dead sensor");
  CHECK(c.judged_until_reason == "a dead sensor");
}

TEST_CASE("a verdict that is withheld leaves no number behind") {
  Collapse c;
  c.kind = CollapseKind::flow;
  c.onset = Instant{.reading = 400};
  c.strength_lost = 0.9;
  c.second_order_work_normalised = -0.2;
  c.second_order_work_error = 0.01;
  c.criteria = {{.name = "a", .detected = true}};
  c.end_at(900, "a sensor");
  CHECK(c.judged);  // what was found before stands
  c.withhold("it depends");
  CHECK_FALSE(c.judged);
  CHECK_FALSE(c.detected());
  CHECK_FALSE(c.onset);
  CHECK_FALSE(c.judged_until);
  CHECK_FALSE(c.strength_lost);
  CHECK_FALSE(c.second_order_work_normalised);
  CHECK_FALSE(c.second_order_work_error);
  CHECK_FALSE(c.criteria[0].detected);
  CHECK(c.judged_until_reason == "it depends");
}
