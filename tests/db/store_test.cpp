// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/store.hpp"

#include <catch2/catch.hpp>

#include "db/recording/recorder.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using testing::TemporaryFolder;

namespace {

using Scans = std::vector<std::pair<lab::Reading, lab::State>>;

Scans read_all(const db::Store& store, std::int64_t id, std::int64_t every = 1) {
  Scans scans;
  store.for_each_scan(id, every, [&](const lab::Reading& reading, const lab::State& state) {
    scans.emplace_back(reading, state);
  });
  return scans;
}

}  // namespace

TEST_CASE("a recorded test comes back bit for bit, raw, reduced and unruly scans alike") {
  TemporaryFolder folder;
  std::mt19937_64 random(7);
  Scans sent;
  for (int i = 0; i < 3000; ++i) {
    auto scan = testing::raw_scan(random, i);
    if (i >= 1000) scan.first.stage = scan.second.stage = 2;
    if (i >= 2000) {
      scan.second = testing::wild_state(random, scan.first);
      scan.first[lab::Quantity::deviator_stress] = scan.second.q * 1.055;
      scan.first[lab::Quantity::void_ratio] = -0.0;
    }
    if (i % 7 == 0) scan.first[lab::Quantity::back_volume] = -0.0;
    if (i % 11 == 0) scan.second.volumetric_strain = -0.0;
    if (i % 13 == 0) scan.first.time_s = scan.second.time_s = lab::kMissing;
    sent.push_back(scan);
  }
  db::Recorder recorder(folder.file("t.db"));
  const lab::SessionListener listener = recorder.listener();
  listener.started(testing::raw_header("a"));
  for (const auto& [reading, state] : sent) listener.scanned(reading, state);
  const std::int64_t id = recorder.finish({});

  const db::Store store(folder.file("t.db"));
  const Scans back = read_all(store, id);
  REQUIRE(back.size() == sent.size());
  CHECK(store.scan_count(id) == 3000);
  for (std::size_t i = 0; i < sent.size(); ++i) {
    INFO("scan " << i);
    REQUIRE(testing::same(sent[i].first, back[i].first));
    REQUIRE(testing::same(sent[i].second, back[i].second));
  }
  for (const std::int64_t reading : {0, 1234, 2999})
    CHECK(testing::same(*store.state_at(id, reading), back[std::size_t(reading)].second));
  CHECK_FALSE(store.state_at(id, 3000));
  CHECK_FALSE(store.state_at(id, -1));
  CHECK_FALSE(store.state_at(id + 1, 0));
  const Scans some = read_all(store, id, 500);
  REQUIRE(some.size() == 6);
  CHECK(some[3].first.number == 1500);
}

TEST_CASE("all that is known of a test comes back, and what is unknown stays unknown") {
  TemporaryFolder folder;
  lab::RecordHeader header = testing::raw_header("csu 26");
  header.origin = lab::Origin::simulated;
  header.seed = 0xfedcba9876543210u;
  header.dialect = "triax";
  header.digest = std::string(64, '7');
  header.specimen.void_ratio = 0.885;
  header.specimen.material = "Hostun S28";
  header.specimen.limit_friction_angle_rad = sim::radians(32);
  header.specimen.cohesion_pa = 12.5e3;
  header.stages.push_back({2, "constant q", lab::StageRole::shear, lab::Drainage::open,
                           lab::AxialControl::constant_q, 0.4});
  header.stages.push_back(
      {3, "safe state", lab::StageRole::hold, lab::Drainage::open, lab::AxialControl::load, {}});
  header.warnings = {{12, "time goes back"}};
  lab::TestSummary summary;
  summary.consolidation = {300e3, 0.97, 0.871, 0.1385, std::nullopt};
  summary.peak = lab::Instant{4, 0.4, 0.0051, 56.5e3, 97e3, 520e3};
  summary.undrained_strength = {.at = {7, 0.7, 0.18, -176e3, {}, {}},
                                .at_15_pct = lab::Instant{6, 0.6, 0.1502, -170e3, {}, {}},
                                .last_axial_strain = 0.19,
                                .peaked = false};
  summary.collapse.limit_intercept_pa = 24.9e3;
  summary.collapse.kind = lab::CollapseKind::flow;
  summary.collapse.inside_limit_surface = true;
  summary.collapse.onset = lab::Instant{5, 0.5, 0.0052, 56.4e3, std::nullopt, 521e3};
  summary.collapse.onset->interval = {{55e3, 57.5e3}, {90e3, 110e3}, {0.55, 0.61}};
  summary.collapse.onset_detected_at = lab::Moment{8, 0.8};
  summary.collapse.onset->total = {.interval = {{53e3, 59e3}, {85e3, 115e3}, {0.5, 0.66}},
                                   .budget = {{"gain of the load cell", 0.6}, {"noise", 0.4}}};
  summary.collapse.loss_of_control = lab::Instant{6, 0.6, 0.006, 50e3, 80e3, 525e3};
  summary.collapse.loss_of_control->interval = {{49e3, 51e3}, {78e3, 82e3}, {0.6, 0.65}};
  summary.collapse.loss_of_control_detected_at = lab::Moment{7, 0.7};
  summary.collapse.second_order_work_normalised = -0.4;
  summary.collapse.second_order_work_error = 0.05;
  summary.collapse.limit_stress_ratio = 1.29;
  summary.collapse.limit_source = "specimen's friction angle";
  summary.collapse.criteria = {{"second_order_work", true, 5, 0.5, 0.58, "fell to -0.4"},
                               {"loss_of_control", false, {}, {}, {}, ""}};
  summary.collapse.criteria[0].detected_at = lab::Moment{7, std::nullopt};
  summary.truth = lab::Truth{true, 0.45, 0.00515, 56.45e3, 97.1e3, std::nullopt, {}};
  summary.truth->run_aways = {{0.45, 2.5e-3, 0.6, 1e-6, -3e-6, 0.7, 0.75,
                               lab::RunAwayEnd::new_equilibrium, 0.006, 51e3, 81e3, 524e3},
                              {0.8, 4e-3, 0.9, {}, {}, {}, {}, lab::RunAwayEnd::none}};
  summary.collapse.judged_until = 7;
  summary.collapse.judged_until_reason = "the pore-pressure transducer is dead";
  summary.checks = {{lab::CheckKind::b_value, 0.97, 0.95, true, "B is high enough"},
                    {lab::CheckKind::rate, {}, {}, false, ""}};
  summary.warnings = {{0, "no limit surface"}};
  summary.readings = 10;

  db::Recorder recorder(folder.file("t.db"));
  const lab::SessionListener listener = recorder.listener();
  listener.started(header);
  testing::send_scans(listener, 0, 10);
  listener.happened({5, 0.5, lab::EventKind::limit_surface, "q fell", lab::Moment{9, 0.9}});
  listener.second_order_work({3, 0.3, {1.5, 1.4, 1.3, 0.9}, 0.02, 51});
  listener.second_order_work({4, lab::kMissing, {1.5, 1.4, 1.3, 0.9}, 0.02, 51, 0.0125});
  listener.foreseen({6, 0.6, -0.6, -0.65, -0.55, {}});
  listener.foreseen(
      {8, 0.8, 0.61, 0.58, 0.64, lab::LeftToOnset{lab::Quantity::deviator_stress, 3.2e3, 12.5}});
  const std::int64_t id = recorder.finish(summary);

  const db::Store store(folder.file("t.db"));
  const auto forecasts = store.forecasts(id);
  REQUIRE(forecasts.size() == 2);
  CHECK(forecasts[0].reading == 6);
  CHECK(forecasts[0].eta_low == -0.65);
  CHECK_FALSE(forecasts[0].left);
  CHECK(forecasts[1].time_s == 0.8);
  CHECK(forecasts[1].eta == 0.61);
  CHECK(forecasts[1].eta_high == 0.64);
  CHECK(forecasts[1].left->quantity == lab::Quantity::deviator_stress);
  CHECK(forecasts[1].left->value == Approx(3.2e3));
  CHECK(forecasts[1].left->time_s == 12.5);
  CHECK(store.forecasts(id + 1).empty());
  const db::StoredTest test = store.load(id);
  CHECK(test.status == db::TestStatus::complete);
  CHECK(test.stored_at.size() == 20);
  const db::TestVersion version = store.version(id);
  CHECK(version.status == test.status);
  CHECK(version.stored_at == test.stored_at);
  CHECK(version.digest == test.header.digest);
  CHECK(version.readings == test.summary.readings);
  CHECK(test.header.name == "csu 26");
  CHECK(test.header.origin == lab::Origin::simulated);
  CHECK(test.header.seed == header.seed);
  CHECK(test.header.programme == "ICU");
  CHECK(test.header.source == "csu 26.csv");
  CHECK(test.header.dialect == "triax");
  CHECK(test.header.digest == header.digest);
  CHECK(test.tags.empty());
  CHECK(test.header.columns == header.columns);
  CHECK(test.header.has_time);
  CHECK(test.header.specimen.height_m == 0.14);
  CHECK(test.header.specimen.void_ratio == 0.885);
  CHECK_FALSE(test.header.specimen.dry_mass_kg);
  CHECK(test.header.specimen.material == "Hostun S28");
  CHECK(*test.header.specimen.limit_friction_angle_rad == Approx(sim::radians(32)).epsilon(1e-15));
  CHECK(*test.header.specimen.cohesion_pa == Approx(12.5e3));
  REQUIRE(test.header.stages.size() == 3);
  CHECK(test.header.stages[1].strain_path_R == 0.4);
  CHECK_FALSE(test.header.stages[0].strain_path_R);
  CHECK(test.header.stages[2].role == lab::StageRole::hold);
  CHECK(test.header.stages[1].name == "constant q");
  CHECK(test.header.stages[1].role == lab::StageRole::shear);
  CHECK(test.header.stages[1].drainage == lab::Drainage::open);
  CHECK(test.header.stages[1].control == lab::AxialControl::constant_q);
  REQUIRE(test.header.warnings.size() == 1);
  CHECK(test.header.warnings[0].line == 12);

  const lab::TestSummary& back = test.summary;
  CHECK(back.consolidation.p_eff_pa == 300e3);
  CHECK(back.consolidation.b_value == 0.97);
  CHECK(back.consolidation.height_m == 0.1385);
  CHECK_FALSE(back.consolidation.diameter_m);
  CHECK(back.peak->reading == 4);
  CHECK(back.peak->q_pa == 56.5e3);
  REQUIRE(back.undrained_strength);
  CHECK(back.undrained_strength->c_u_pa() == Approx(88e3));
  CHECK(back.undrained_strength->at.reading == 7);
  CHECK(back.undrained_strength->at.axial_strain == 0.18);
  CHECK(back.undrained_strength->last_axial_strain == 0.19);
  CHECK_FALSE(back.undrained_strength->peaked);
  CHECK(back.undrained_strength->at_15_pct->reading == 6);
  CHECK(*back.undrained_strength->at_15_pct->q_pa == Approx(-170e3));
  CHECK(*back.collapse.limit_intercept_pa == Approx(24.9e3));
  CHECK(back.collapse.kind == lab::CollapseKind::flow);
  CHECK(back.collapse.inside_limit_surface == true);
  CHECK(back.collapse.onset->reading == 5);
  CHECK_FALSE(back.collapse.onset->p_eff_pa);
  CHECK(back.collapse.onset->pore_pressure_pa == 521e3);
  CHECK(back.collapse.second_order_work_normalised == -0.4);
  CHECK(back.collapse.limit_source == "specimen's friction angle");
  REQUIRE(back.collapse.criteria.size() == 2);
  CHECK(back.collapse.criteria[0].evidence == "fell to -0.4");
  CHECK(back.collapse.criteria[0].eta == 0.58);
  CHECK_FALSE(back.collapse.criteria[1].reading);
  REQUIRE(back.collapse.criteria[0].detected_at);
  CHECK(back.collapse.criteria[0].detected_at->reading == 7);
  CHECK_FALSE(back.collapse.criteria[0].detected_at->time_s);
  CHECK_FALSE(back.collapse.criteria[1].detected_at);
  REQUIRE(back.collapse.onset_detected_at);
  CHECK(back.collapse.onset_detected_at->reading == 8);
  CHECK(back.collapse.onset_detected_at->time_s == 0.8);
  REQUIRE(back.collapse.onset->interval);
  CHECK(back.collapse.onset->interval->q_pa.low == Approx(55e3));
  CHECK(back.collapse.onset->interval->q_pa.high == Approx(57.5e3));
  CHECK(back.collapse.onset->interval->p_eff_pa.low == Approx(90e3));
  CHECK(back.collapse.onset->interval->p_eff_pa.high == Approx(110e3));
  CHECK(back.collapse.onset->interval->eta.low == 0.55);
  CHECK(back.collapse.onset->interval->eta.high == 0.61);
  REQUIRE(back.collapse.onset->total);
  CHECK(back.collapse.onset->total->interval.eta.low == 0.5);
  CHECK(back.collapse.onset->total->interval.q_pa.high == Approx(59e3));
  REQUIRE(back.collapse.onset->total->budget.size() == 2);
  CHECK(back.collapse.onset->total->budget[0].name == "gain of the load cell");
  CHECK(back.collapse.onset->total->budget[0].share == 0.6);
  REQUIRE(back.collapse.loss_of_control);
  CHECK(back.collapse.loss_of_control->reading == 6);
  CHECK(back.collapse.loss_of_control->time_s == 0.6);
  CHECK(back.collapse.loss_of_control->axial_strain == 0.006);
  CHECK(back.collapse.loss_of_control->q_pa == Approx(50e3));
  CHECK(back.collapse.loss_of_control->p_eff_pa == Approx(80e3));
  CHECK(back.collapse.loss_of_control->pore_pressure_pa == 525e3);
  REQUIRE(back.collapse.loss_of_control->interval);
  CHECK(back.collapse.loss_of_control->interval->eta.high == 0.65);
  REQUIRE(back.collapse.loss_of_control_detected_at);
  CHECK(back.collapse.loss_of_control_detected_at->time_s == 0.7);
  REQUIRE(test.events.back().detected_at);
  CHECK(test.events.back().detected_at->reading == 9);
  CHECK(test.events.back().detected_at->time_s == 0.9);
  CHECK(back.truth->lost_sustainability);
  CHECK(back.truth->time_s == 0.45);
  CHECK_FALSE(back.truth->pore_pressure_pa);
  REQUIRE(back.truth->run_aways.size() == 2);
  CHECK(back.truth->run_aways[0].start_s == 0.45);
  CHECK(back.truth->run_aways[0].axial_strain == 0.006);
  CHECK(back.truth->run_aways[0].q_pa == Approx(51e3));
  CHECK(back.truth->run_aways[0].p_eff_pa == Approx(81e3));
  CHECK(back.truth->run_aways[0].pore_pressure_pa == Approx(524e3));
  CHECK_FALSE(back.truth->run_aways[1].q_pa);
  CHECK(back.truth->run_aways[0].largest_kinetic_energy_j == 2.5e-3);
  CHECK(back.truth->run_aways[0].largest_at_s == 0.6);
  CHECK(back.truth->run_aways[0].kinetic_energy_j == 1e-6);
  CHECK(back.truth->run_aways[0].second_order_work_j == -3e-6);
  CHECK(back.truth->run_aways[0].expected_ratio == 0.7);
  CHECK(back.truth->run_aways[0].end_s == 0.75);
  CHECK(back.truth->run_aways[0].end == lab::RunAwayEnd::new_equilibrium);
  CHECK_FALSE(back.truth->run_aways[1].kinetic_energy_j);
  CHECK_FALSE(back.truth->run_aways[1].end_s);
  CHECK(back.collapse.judged_until == 7);
  CHECK(back.collapse.judged_until_reason == "the pore-pressure transducer is dead");
  CHECK_FALSE(test.sweep);
  REQUIRE(back.checks.size() == 2);
  CHECK(back.checks[0].ok);
  CHECK_FALSE(back.checks[1].measured);
  REQUIRE(back.warnings.size() == 1);
  CHECK(back.warnings[0].line == 0);
  CHECK(back.readings == 10);
  REQUIRE(test.events.size() == 1);
  CHECK(test.events[0].kind == lab::EventKind::limit_surface);
  const auto work = store.second_order_work(id);
  REQUIRE(work.size() == 2);
  CHECK(work[0].reading == 3);
  CHECK(work[0].time_s == 0.3);
  CHECK(std::isnan(work[0].axial_strain_path));
  CHECK(std::isnan(work[1].time_s));
  CHECK(work[1].axial_strain_path == 0.0125);
  CHECK(work[0].work.eulerian == 1.4);
  CHECK(work[0].window_readings == 51);
}

namespace {

void record_tests(const std::string& path, const std::vector<std::string>& names) {
  for (const auto& name : names) {
    db::Recorder recorder(path);
    const lab::SessionListener listener = recorder.listener();
    listener.started(testing::raw_header(name));
    testing::send_scans(listener, 0, 2);
    recorder.finish({});
  }
}

}  // namespace

TEST_CASE("tests are found by name, latest first, or by id") {
  TemporaryFolder folder;
  record_tests(folder.file("t.db"), {"a", "b", "a", "1"});
  const db::Store store(folder.file("t.db"));
  CHECK(store.find({}) == std::vector<std::int64_t>{1, 2, 3, 4});
  CHECK(store.find({"a", "b", "2", "1"}) == std::vector<std::int64_t>{3, 2, 2, 4});
  CHECK_THROWS_AS(store.find({"c"}), lab::BadInput);
  CHECK_THROWS_AS(store.load(77), lab::BadInput);
  CHECK_THROWS_AS(store.version(77), lab::BadInput);
}

TEST_CASE("a short name is enough where it can mean one test only") {
  TemporaryFolder folder;
  record_tests(folder.file("t.db"), {"ICU 42", "CSU 26", "CSU 26", "CSU 42", "a_b"});
  const db::Store store(folder.file("t.db"));
  CHECK(store.find({"csu_26", "26", "Icu 42", "A B"}) == std::vector<std::int64_t>{3, 3, 1, 5});
  CHECK(store.find({"2"}) == std::vector<std::int64_t>{2});  // an id goes first
  CHECK_THROWS_WITH(store.find({"42"}), Catch::Contains("is ambiguous: 'CSU 42' or 'ICU 42'"));
  for (const char* nothing : {"6", "CSU", "SU 26", "%", ""})
    CHECK_THROWS_AS(store.find({nothing}), lab::BadInput);
}

TEST_CASE("beside a fitted onset stands what its reading holds") {
  TemporaryFolder folder;
  std::mt19937_64 random(9);
  db::Recorder recorder(folder.file("t.db"));
  const lab::SessionListener listener = recorder.listener();
  listener.started(testing::raw_header("a"));
  lab::State third;
  for (int i = 0; i < 10; ++i) {
    const auto scan = testing::raw_scan(random, i);
    if (i == 3) third = scan.second;
    listener.scanned(scan.first, scan.second);
  }
  lab::TestSummary summary;
  summary.collapse.kind = lab::CollapseKind::flow;
  summary.collapse.onset = lab::Instant{.reading = 3, .q_pa = 1};
  const std::int64_t id = recorder.finish(summary);
  const auto stored = db::Store(folder.file("t.db")).load(id);
  REQUIRE(stored.state_at_onset);
  CHECK(testing::same(*stored.state_at_onset, third));
}
