// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/assessment.hpp"

#include <catch2/catch.hpp>

#include "lab/collapse/criteria.hpp"
#include "lab/collapse/second_order_work.hpp"
#include "lab/collapse/stress_span.hpp"
#include "sim/mechanics/axisymmetric.hpp"
#include "tests/lab/collapse/evidence_samples.hpp"

using namespace triax::lab;
using samples::descent;
using samples::sand;

namespace {

/// With the criteria as they would stand beside that evidence.
Collapse assess(const Evidence& e) {
  std::vector<Criterion> criteria;
  for (const CriterionRow& row : collapse_criteria())
    criteria.push_back(criterion_of(row, std::nullopt));
  criteria[0].detected = e.worst || e.at_held_q;
  criteria[1] = criterion_of(collapse_criteria()[1], e.loss_of_control);
  criteria[2] = criterion_of(collapse_criteria()[2], e.control_peak);
  return triax::lab::assess(e, std::move(criteria));
}

CollapseKind kind(const Descent& d) {
  const LimitSurface limit = sand();
  return assess({.worst = d, .points = 50, .limit = limit}).kind;
}

}  // namespace

TEST_CASE("kinds follow what was lost and what came back") {
  CHECK(kind(descent(100e3, 150e3, 95e3, 6e3)) == CollapseKind::flow);
  CHECK(kind(descent(100e3, 150e3, 60e3, 75e3)) ==
        CollapseKind::limited);  // more than half came back
  CHECK(kind(descent(100e3, 150e3, 28e3, 90e3)) == CollapseKind::limited);
  CHECK(kind(descent(100e3, 150e3, 28e3, 72e3)) == CollapseKind::partial);  // and stops there
  CHECK(kind(descent(100e3, 150e3, 8e3, 92e3)) == CollapseKind::none);
}

TEST_CASE("on the limit surface nothing is a diffuse collapse") {
  const LimitSurface limit = sand();
  const Collapse c =
      assess({.worst = descent(126e3, 100e3, 60e3, 66e3), .points = 50, .limit = limit});
  CHECK(c.kind == CollapseKind::none);
  CHECK(c.inside_limit_surface == false);
  CHECK_FALSE(c.criteria[0].found());
  CHECK(c.criteria[0].evidence.find("a failure on the limit surface") != std::string::npos);
}

TEST_CASE("a drained peak is a failure where nobody knows that it lies inside the limit") {
  const LimitSurface unknown({}), given = sand();
  Descent peak = descent(100e3, 120e3, 16e3, 84e3);
  peak.drained = true;
  const Collapse c = assess({.worst = peak, .points = 50, .limit = unknown});
  CHECK(c.judged);
  CHECK(c.kind == CollapseKind::none);
  CHECK(c.onset);
  CHECK(*c.strength_lost == Approx(0.16));
  CHECK_FALSE(c.inside_limit_surface);
  CHECK_THAT(c.criteria[0].evidence, Catch::Contains("drained failure"));
  CHECK(assess({.worst = peak, .points = 50, .limit = given}).kind == CollapseKind::partial);
  peak.drained = false;
  CHECK(assess({.worst = peak, .points = 50, .limit = unknown}).kind == CollapseKind::partial);

  // From a fiftieth on it is reported, if second-order work was negative beyond its error.
  Descent small = descent(100e3, 120e3, 4e3, 96e3);
  small.drained = true;
  small.evidence.normalised_error = 0.05;
  CHECK(assess({.worst = small, .points = 50, .limit = unknown}).onset);
  small.evidence.normalised_error = 0.1;
  CHECK_FALSE(assess({.worst = small, .points = 50, .limit = unknown}).onset);
}

TEST_CASE("verdict: a larger ratio of the same test leaves the limit unknown") {
  LimitSurface own({});
  for (int i = 1; i <= 10; ++i) own.add(i, 12e3, 10e3);
  Descent fall = descent(60e3, 100e3, 40e3, 20e3);
  for (const bool drained : {false, true}) {
    fall.drained = drained;
    const Collapse c = assess({.worst = fall, .points = 50, .limit = own});
    CHECK(c.kind == CollapseKind::flow);  // η of 0.6 where 1.2 was carried: no failure on a limit
    CHECK_FALSE(c.inside_limit_surface);
    CHECK_FALSE(c.limit_stress_ratio);
    CHECK_THAT(c.limit_source, Catch::Contains("unknown: no friction angle is given"));
  }
  const LimitSurface given = sand();
  CHECK(assess({.worst = fall, .points = 50, .limit = given}).limit_source == kGivenLimit);
}

TEST_CASE("Collapse: a loss at a ratio that needs cohesion is not assessed") {
  const LimitSurface unknown({});
  const Descent fall = descent(220e3, 100e3, 40e3, 180e3);
  const Collapse c = assess({.worst = fall, .points = 50, .limit = unknown});
  CHECK_FALSE(c.judged);
  CHECK_FALSE(c.onset);
  CHECK_FALSE(c.strength_lost);
  CHECK(c.judged_until == 10);
  CHECK_THAT(c.judged_until_reason, Catch::Contains("over-consolidated clay"));
  CHECK_FALSE(c.criteria[0].detected);
  SpecimenInfo clay;
  clay.cohesion_pa = 30e3;
  clay.limit_friction_angle_rad = triax::sim::radians(40);
  const LimitSurface given(clay);  // 1.636 · 100 kPa + 58.5 kPa = 222 kPa
  const Collapse failed = assess({.worst = fall, .points = 50, .limit = given});
  CHECK(failed.judged);
  CHECK(failed.kind == CollapseKind::none);
  CHECK(failed.inside_limit_surface == false);
  CHECK(*failed.limit_stress_ratio == Approx(1.636).margin(1e-3));
  CHECK(*failed.limit_intercept_pa == Approx(58.5e3).margin(0.1e3));
}

TEST_CASE("verdict: a failure shows the limit, and takes it along when it is withheld") {
  LimitSurface walked({});
  for (int i = 1; i <= 100; ++i) walked.add(i, 1.3e3 * i, 1e3 * i);
  Descent peak = descent(130e3, 100e3, 20e3, 110e3);
  peak.onset.reading = 101;
  Collapse c = assess({.worst = peak, .points = 50, .limit = walked});
  CHECK(c.inside_limit_surface == false);
  CHECK(*c.limit_stress_ratio == Approx(1.3));
  c.withhold("the load cell is dead");
  CHECK_FALSE(c.limit_stress_ratio);
  CHECK(c.limit_source == "unknown");
}

TEST_CASE("a burst on a limit that only the burst shows is a collapse") {
  LimitSurface own({});
  PathPoint last;
  last.q = 60e3;
  last.p_eff = 90e3;
  own.add(last.reading, last.q, last.p_eff);
  const Finding burst{.instant = {.reading = 20, .q_pa = 60e3, .p_eff_pa = 90e3},
                      .evidence = "ran"};
  const Collapse c = assess({.loss_of_control = burst, .points = 50, .limit = own});
  CHECK(c.kind == CollapseKind::flow);
  CHECK_FALSE(c.inside_limit_surface);
}

TEST_CASE("none says how near it came") {
  const LimitSurface limit = sand();
  const Collapse c = assess({.points = 50,
                             .first_state = 7,
                             .nearest = Nearest{.reading = 30, .normalised = 0.1, .error = 0.02},
                             .limit = limit});
  CHECK(c.judged);
  CHECK(c.judged_from == 7);
  REQUIRE(c.nearest);
  CHECK(c.nearest->reading == 30);
}

TEST_CASE("verdict: yielding at held q is a flow only if something is lost") {
  const LimitSurface limit = sand();
  Descent held = descent(60e3, 105e3, 0, 60e3);
  held.axial_strain_last = held.onset.axial_strain + 0.02;
  CHECK(lasts_at_held_q(held));
  const Collapse carried = assess({.at_held_q = held, .points = 50, .limit = limit});
  CHECK(carried.kind == CollapseKind::none);
  CHECK_FALSE(carried.onset);
  const Finding lost{.instant = {.reading = 20}, .evidence = "q fell"};
  CHECK(assess({.at_held_q = held, .loss_of_control = lost, .points = 50, .limit = limit}).kind ==
        CollapseKind::flow);
  CHECK(assess({.worst = descent(60e3, 105e3, 9e3, 51e3),
                .at_held_q = held,
                .points = 50,
                .limit = limit})
            .kind == CollapseKind::flow);
  held.came_back = true;
  CHECK_FALSE(lasts_at_held_q(held));
  CHECK(assess({.worst = descent(60e3, 105e3, 9e3, 60e3),
                .at_held_q = held,
                .points = 50,
                .limit = limit})
            .kind == CollapseKind::limited);
}

TEST_CASE("a burst alone is a collapse where no window could be filled") {
  const LimitSurface limit = sand();
  const Finding burst{.instant = {.reading = 20, .q_pa = 60e3, .p_eff_pa = 100e3},
                      .evidence = "ran"};
  const Collapse c = assess({.loss_of_control = burst, .points = 50, .limit = limit});
  CHECK(c.kind == CollapseKind::flow);
  CHECK(c.onset->reading == 20);
  CHECK(c.inside_limit_surface == true);
  CHECK(assess({.points = 50, .limit = limit}).kind == CollapseKind::none);
}

TEST_CASE("too little seen of shear is not judged, which is not the same as no collapse") {
  const LimitSurface limit = sand();
  const Collapse c = assess({.states = 5, .limit = limit});
  CHECK_FALSE(c.judged);
  CHECK(c.judged_until_reason == "too few readings in shear, 5 complete states of the 7 needed");
  REQUIRE(c.criteria.size() == 3);
  CHECK_FALSE(c.criteria[0].detected);
  CHECK(c.criteria[0].evidence.find(
            "too few readings in shear, 5 complete states of the 7 needed") != std::string::npos);
  CHECK(assess({.points = 1, .limit = limit}).judged);
}

TEST_CASE("at held q with the valve closed the pore pressure places the onset") {
  const LimitSurface limit = sand();
  const Finding turn{.instant = {.reading = 4, .q_pa = 60e3, .p_eff_pa = 105e3}, .evidence = "u"};
  const Descent fall = descent(60e3, 100e3, 58e3, 2e3);
  CHECK(
      assess({.worst = fall, .control_peak = turn, .points = 50, .limit = limit}).onset->reading ==
      10);
  const Collapse c = assess({.worst = fall,
                             .control_peak = turn,
                             .volume_by_pore_pressure = true,
                             .points = 50,
                             .limit = limit});
  CHECK(c.onset->reading == 4);
  CHECK(c.kind == CollapseKind::flow);
}

TEST_CASE("a fall is the onset, whatever the volume did before; alone it is a flow") {
  const LimitSurface limit = sand();
  const Instant fall{.reading = 90, .q_pa = 60e3, .p_eff_pa = 100e3};
  const Finding burst{fall, "which q fell"};
  Descent held = descent(60e3, 105e3, 0, 60e3);
  held.axial_strain_last = held.onset.axial_strain + 0.02;
  const Finding turn{{.reading = 40, .q_pa = 60e3, .p_eff_pa = 110e3}, "turned"};
  const Collapse c = assess({.at_held_q = held,
                             .loss_of_control = burst,
                             .fall = fall,
                             .control_peak = turn,
                             .points = 50,
                             .limit = limit});
  REQUIRE(c.onset);
  CHECK(c.onset->reading == 90);
  CHECK(c.criteria[2].reading == 40);
  const Collapse alone =
      assess({.loss_of_control = burst, .fall = fall, .points = 50, .limit = limit});
  CHECK(alone.kind == CollapseKind::flow);
  CHECK(alone.onset->reading == 90);
}

TEST_CASE(
    "a collapse over in a reading or two keeps the onset that the pore pressure showed before") {
  const LimitSurface limit = sand();
  const Finding turn{.instant = {.reading = 4, .q_pa = 60e3, .p_eff_pa = 105e3}, .evidence = "u"};
  const Finding burst{.instant = {.reading = 40, .q_pa = 60e3, .p_eff_pa = 100e3},
                      .evidence = "strain"};
  const auto with = [&](bool gauge) {
    return assess({.loss_of_control = burst,
                   .control_peak = turn,
                   .volume_by_pore_pressure = gauge,
                   .points = 50,
                   .limit = limit});
  };
  CHECK(with(true).onset->reading == 4);
  CHECK(with(true).kind == CollapseKind::flow);
  CHECK(with(false).onset->reading == 40);
}

TEST_CASE("a limit of the test's own excuses no undrained loss of most of the strength") {
  SpecimenInfo unknown;
  LimitSurface walked(unknown);  // dq = 3 dp': the pore pressure is dead
  for (int i = 1; i <= 100; ++i) {
    PathPoint p;
    p.reading = i;
    p.q = 1e3 * i;
    p.p_eff = 20e3 + p.q / 3;
    walked.add(p.reading, p.q, p.p_eff);
  }
  auto fall = descent(100e3, 53.3e3, 90e3, 11e3);
  fall.onset.reading = 101;
  CHECK(walked.inside(fall.onset.q, fall.onset.p_eff, 101) == false);
  CHECK(assess({.worst = fall, .points = 50, .limit = walked}).kind == CollapseKind::flow);
  fall.drained = true;
  CHECK(assess({.worst = fall, .points = 50, .limit = walked}).kind == CollapseKind::none);
}

TEST_CASE("verdict: a record that ends past its onset is not assessed") {
  const LimitSurface limit = sand();
  Descent fall = descent(100e3, 150e3, 100, 99.9e3);
  fall.evidence.normalised_error = 0.02;
  const auto with = [&](const Descent& latest) {
    return assess({.worst = latest, .latest = latest, .points = 50, .limit = limit});
  };
  const Collapse cut = with(fall);
  CHECK_FALSE(cut.judged);
  CHECK(cut.judged_until == 10);
  CHECK_THAT(cut.judged_until_reason, Catch::Contains("0.1 % of q was lost"));

  Descent turned = descent(100e3, 150e3, 6e3, 95e3);
  turned.evidence.normalised_error = 0.02;  // it has turned
  CHECK(with(turned).judged);
  Descent over = fall;
  over.ended = true;
  CHECK(with(over).judged);
  Descent drained = fall;
  drained.drained = true;
  CHECK(with(drained).judged);
  Descent unsure = fall;
  unsure.evidence.normalised_error = 0.1;
  CHECK(with(unsure).judged);
  Descent on_limit = descent(127e3, 100e3, 100, 126.9e3);
  on_limit.evidence.normalised_error = 0.02;
  CHECK(with(on_limit).judged);
}

TEST_CASE("assess: a record that ends with negative work is not assessed") {
  const LimitSurface limit = sand();
  const auto with = [&](double q) {
    const Instant last{.reading = 40, .q_pa = q, .p_eff_pa = 100e3};
    return assess({.negative_at_end = last, .points = 50, .limit = limit});
  };
  CHECK_FALSE(with(60e3).judged);
  CHECK(with(60e3).judged_until == 40);
  CHECK_THAT(with(60e3).judged_until_reason, Catch::Contains("negative in the last readings"));
  CHECK(with(127e3).judged);  // dense sand on its limit
}

TEST_CASE("verdict: at held q the turn of the volume is known before the fall") {
  const LimitSurface limit = sand();
  const Finding turn{.instant = {.reading = 4, .q_pa = 60e3, .p_eff_pa = 105e3},
                     .evidence = "turned",
                     .noticed = Moment{8, 8.0}};
  const Finding burst{.instant = {.reading = 40, .q_pa = 60e3, .p_eff_pa = 100e3},
                      .evidence = "strain",
                      .noticed = Moment{42, 42.0}};
  const auto noticed = [&](bool at_held_q) {
    return assess({.loss_of_control = burst,
                   .control_peak = turn,
                   .turned_at_held_q = at_held_q,
                   .points = 50,
                   .limit = limit})
        .onset_detected_at->reading;
  };
  CHECK(noticed(true) == 8);
  CHECK(noticed(false) == 42);  // a peak of q that came back
}

TEST_CASE("a verdict is known when the first of what it rests on was") {
  const LimitSurface limit = sand();
  Descent lost = descent(100e3, 150e3, 95e3, 6e3);
  lost.noticed = Moment{70, 7.0};
  lost.interval = as_interval(100e3, 150e3);
  Finding control{.instant = {.reading = 12, .q_pa = 90e3, .p_eff_pa = 140e3},
                  .evidence = "burst",
                  .noticed = Moment{40, 4.0}};
  const Collapse both =
      assess({.worst = lost, .loss_of_control = control, .points = 50, .limit = limit});
  REQUIRE(both.onset_detected_at);
  CHECK(both.onset_detected_at->reading == 40);
  CHECK(both.criteria[1].detected_at->reading == 40);
  REQUIRE(both.onset->interval);
  CHECK(both.onset->interval->q_pa.holds(100e3));
  const Collapse one = assess({.worst = lost, .points = 50, .limit = limit});
  CHECK(one.onset_detected_at->reading == 70);
  lost.noticed.reset();
  CHECK_FALSE(assess({.worst = lost, .points = 50, .limit = limit}).onset_detected_at);
  CHECK_FALSE(assess({.worst = descent(100e3, 150e3, 1e3, 99e3), .points = 50, .limit = limit})
                  .onset_detected_at);
}

TEST_CASE("verdict: the loss of control is reported beside an earlier onset", "[collapse]") {
  const LimitSurface limit = sand();
  Descent turned = descent(100e3, 150e3, 95e3, 6e3);
  turned.noticed = Moment{90, 9.0};
  const Finding runaway{.instant = {.reading = 80,
                                    .time_s = 8.0,
                                    .axial_strain = 0.02,
                                    .q_pa = 98e3,
                                    .p_eff_pa = 120e3,
                                    .interval = as_interval(98e3, 120e3)},
                        .evidence = "burst",
                        .noticed = Moment{82, 8.2}};
  const Collapse c =
      assess({.at_held_q = turned, .loss_of_control = runaway, .points = 50, .limit = limit});
  CHECK(c.onset->reading == 10);
  REQUIRE(c.loss_of_control);
  CHECK(c.loss_of_control->reading == 80);
  CHECK(c.loss_of_control->q_pa == 98e3);
  REQUIRE(c.loss_of_control->interval);
  CHECK(c.loss_of_control->interval->q_pa.holds(98e3));
  REQUIRE(c.loss_of_control_detected_at);
  CHECK(c.loss_of_control_detected_at->reading == 82);
}

TEST_CASE("verdict: no loss of control without a runaway", "[collapse]") {
  const LimitSurface limit = sand();
  const Collapse c =
      assess({.worst = descent(100e3, 150e3, 95e3, 6e3), .points = 50, .limit = limit});
  CHECK(c.detected());
  CHECK_FALSE(c.loss_of_control);
  CHECK_FALSE(c.loss_of_control_detected_at);
}

TEST_CASE("verdict: a runaway on the limit surface is still a loss of control", "[collapse]") {
  const LimitSurface limit = sand();
  const Finding runaway{.instant = {.reading = 80, .q_pa = 194e3, .p_eff_pa = 150e3},
                        .evidence = "burst"};
  const Collapse c = assess({.loss_of_control = runaway, .points = 50, .limit = limit});
  CHECK(c.kind == CollapseKind::none);
  REQUIRE(c.loss_of_control);
  CHECK(c.loss_of_control->reading == 80);
  CHECK_FALSE(c.loss_of_control_detected_at);
}

TEST_CASE("verdict: stress that vanished counts unless there was a runaway", "[collapse]") {
  const LimitSurface limit = sand();
  const Finding gone{.instant = {.reading = 95, .q_pa = 0, .p_eff_pa = 1e3}, .evidence = "gone"};
  const Finding runaway{.instant = {.reading = 80, .q_pa = 90e3, .p_eff_pa = 140e3},
                        .evidence = "burst"};
  const Descent d = descent(100e3, 150e3, 95e3, 6e3);
  CHECK(assess({.worst = d, .zero_stress = gone, .points = 50, .limit = limit})
            .loss_of_control->reading == 95);
  CHECK(assess({.worst = d,
                .loss_of_control = runaway,
                .zero_stress = gone,
                .points = 50,
                .limit = limit})
            .loss_of_control->reading == 80);
}
