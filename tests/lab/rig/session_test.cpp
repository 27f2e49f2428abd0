// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/session.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "tests/lab/reduction/raw_record.hpp"

using namespace triax::lab;

namespace {

/// An undrained test in closed form, drawn like any back end.
class FakeRig : public BackEnd {
 public:
  explicit FakeRig(int readings, int fails_at = -1) : readings_(readings), fails_at_(fails_at) {
    header_ = triax::lab::testing::raw_header();
    header_.stages = {{.number = 3,
                       .name = "shear",
                       .role = StageRole::shear,
                       .drainage = Drainage::closed,
                       .control = AxialControl::displacement}};
  }
  const RecordHeader& header() const override { return header_; }
  bool next(Reading& reading) override {
    if (i_ == fails_at_) throw BadInput("fake", i_, "made to fail");
    if (i_ == readings_) return false;
    const double mm = 0.002 * i_, x = mm / 0.8;
    reading = triax::lab::testing::reading(
        {3, mm, 0.5 * x * std::exp(1 - x), 800, 500 + 250 * (1 - std::exp(-x / 2)), 0}, i_++);
    return true;
  }
  double progress() const override { return double(i_) / readings_; }
  bool abort(const std::string& reason) override {
    aborted_for = reason;
    return false;
  }

  void cut_short(const std::string& why) { header_.cut_short = why; }

  std::string aborted_for;

 private:
  RecordHeader header_;
  int readings_, fails_at_, i_ = 0;
};

}  // namespace

TEST_CASE("listeners are told of every reading in order, and the summary says what they came to") {
  FakeRig rig(3000);
  std::int64_t scans = 0, points = 0, heard_by_second = 0;
  std::vector<EventKind> events;
  SessionListener listener;
  listener.scanned = [&](const Reading& r, const State& s) {
    REQUIRE(r.number == scans);
    REQUIRE(s.reading == scans);
    ++scans;
  };
  listener.second_order_work = [&](const SecondOrderWorkPoint&) { ++points; };
  listener.happened = [&](const Event& e) { events.push_back(e.kind); };
  double progress = -1;
  const SessionListener second = {.scanned =
                                      [&](const Reading&, const State&) {
                                        ++heard_by_second;
                                        CHECK(heard_by_second == scans);
                                      },
                                  .progressed =
                                      [&](double share) {
                                        CHECK(share >= progress);
                                        progress = share;
                                      }};
  const TestSummary summary = run_session(rig, {}, {listener, second});
  CHECK(heard_by_second == 3000);
  CHECK(progress == 1);
  CHECK(scans == 3000);
  CHECK(summary.readings == 3000);
  CHECK(points > 100);
  CHECK(events == std::vector{EventKind::stage_started, EventKind::approaching, EventKind::imminent,
                              EventKind::loss_of_sustainability});
  CHECK(summary.collapse.kind == CollapseKind::flow);
  CHECK(std::abs(summary.collapse.onset->reading - 400) < 8);
  CHECK(std::abs(summary.peak->reading - 400) < 8);
}

TEST_CASE("speed changes nothing but the time it takes") {
  const auto run = [](double speed) {
    FakeRig rig(1000);
    std::vector<double> states;
    const SessionListener listener = {.scanned = [&](const Reading&, const State& s) {
      states.insert(states.end(), {s.q, s.p_eff, s.strain.axial});
    }};
    run_session(rig, {.speed = speed}, {listener});
    return states;
  };
  CHECK(run(0) == run(5000));
}

TEST_CASE("a test that is stopped is judged as far as it went and says when") {
  FakeRig rig(3000);
  std::int64_t scans = 0;
  const SessionListener listener = {.scanned = [&](const Reading&, const State&) { ++scans; }};
  const TestSummary summary = run_session(rig, {.stop = [&] { return scans == 1500; }}, {listener});
  CHECK(scans == 1500);
  CHECK(summary.readings == 1500);
  CHECK(summary.collapse.kind == CollapseKind::flow);
  CHECK(rig.aborted_for.find("aborted by the operator at ") == 0);
  REQUIRE_FALSE(summary.warnings.empty());
  CHECK(summary.warnings[0].text == rig.aborted_for);
}

TEST_CASE("a stop is heard while the clock is waited for") {
  FakeRig rig(1000);
  const auto start = std::chrono::steady_clock::now();
  const auto since = [&] { return std::chrono::steady_clock::now() - start; };
  const TestSummary summary = run_session(
      rig, {.speed = 0.01, .stop = [&] { return since() > std::chrono::milliseconds(250); }});
  CHECK(since() < std::chrono::seconds(5));
  CHECK(summary.readings < 10);
}

TEST_CASE("a back end that fails leaves the readings that were told standing") {
  FakeRig rig(1000, 500);
  int scans = 0;
  const SessionListener listener = {.scanned = [&](const Reading&, const State&) { ++scans; }};
  CHECK_THROWS_AS(run_session(rig, {}, {listener}), BadInput);
  CHECK(scans == 500);
}

TEST_CASE("what a listener throws ends the test and reaches who runs it") {
  FakeRig rig(1000);
  int scans = 0;
  const SessionListener full = {.scanned = [&](const Reading&, const State&) {
    if (++scans == 7) throw WorkFailed("the disk is full");
  }};
  CHECK_THROWS_AS(run_session(rig, {}, {full}), WorkFailed);
  CHECK(scans == 7);
}

TEST_CASE("a verdict that another answer contradicts is withheld, and both are named") {
  const auto judged = [](CollapseKind other, bool other_judged, int* asked) {
    FakeRig rig(3000);
    SessionOptions options;
    options.otherwise = [=] {
      ++*asked;
      Otherwise one{.taken = "stage 3 was assumed to be shear, drainage closed",
                    .said = "stages.3.drainage=open",
                    .collapse = {}};
      one.collapse.kind = other;
      one.collapse.judged = other_judged;
      return std::vector{one};
    };
    return run_session(rig, options).collapse;
  };
  int asked = 0;
  const Collapse taken = judged(CollapseKind::limited, true, &asked);
  CHECK(asked == 1);
  REQUIRE(taken.kind == CollapseKind::flow);  // another kind of collapse is no contradiction
  const Collapse doubtful = judged(CollapseKind::none, true, &asked);
  CHECK_FALSE(doubtful.judged);
  CHECK_FALSE(doubtful.onset);
  for (const std::string& part :
       {std::string("the assessment depends on"), std::string("flow at reading "),
        std::string("drainage closed"), std::string("stages.3.drainage=open gives no collapse")})
    CHECK(doubtful.judged_until_reason.find(part) != std::string::npos);
  // An answer with which nothing can be judged contradicts nothing.
  CHECK(judged(CollapseKind::none, false, &asked).kind == CollapseKind::flow);
}

TEST_CASE("a test that was cut short earns no verdict of none; a collapse before that stands") {
  FakeRig whole(300);  // q rises throughout
  const Collapse none = run_session(whole, {}).collapse;
  CHECK(none.judged);
  CHECK_FALSE(none.detected());

  const std::string why = "stage \"shear\" ended: the law gives no result from there on";
  FakeRig cut(300);
  cut.cut_short(why);
  const Collapse open = run_session(cut, {}).collapse;
  CHECK_FALSE(open.judged);
  CHECK(open.judged_until == 299);
  CHECK(open.judged_until_reason == why);
  for (const Criterion& c : open.criteria) CHECK_FALSE(c.detected);

  FakeRig lost(3000);  // q has fallen to nothing long before
  lost.cut_short(why);
  const Collapse fell = run_session(lost, {}).collapse;
  CHECK(fell.judged);
  CHECK(fell.detected());
}

TEST_CASE("what happened and what was found are known at the last reading taken by then") {
  FakeRig rig(3000);
  std::int64_t last = -1, losses = 0;
  SessionListener listener;
  listener.scanned = [&](const Reading& r, const State&) { last = r.number; };
  listener.happened = [&](const Event& event) {
    if (event.kind == EventKind::stage_started) {
      REQUIRE(event.detected_at);
      CHECK(event.detected_at->reading == event.reading);
    }
    if (event.kind != EventKind::loss_of_sustainability) return;
    ++losses;
    REQUIRE(event.detected_at);
    CHECK(event.detected_at->reading == last);
    CHECK(event.detected_at->reading > event.reading);
  };
  const TestSummary summary = run_session(rig, {}, {listener});
  CHECK(losses == 1);
  const Collapse& c = summary.collapse;
  REQUIRE(c.detected());
  REQUIRE(c.onset_detected_at);
  CHECK(c.onset_detected_at->reading > c.onset->reading);
  CHECK(c.onset_detected_at->reading < 2999);
  REQUIRE(c.onset->interval);
  CHECK(c.onset->interval->eta.holds(*c.onset->eta()));
}

TEST_CASE("run_session: a record that ends while imminent is in force is not assessed") {
  // q peaks at reading 400.
  FakeRig cut(390);
  const Collapse c = run_session(cut, {}).collapse;
  REQUIRE(c.imminent);
  CHECK_FALSE(c.judged);
  CHECK(c.judged_until == 389);
  CHECK_THAT(c.judged_until_reason, Catch::Contains("`imminent`"));
  FakeRig far(200);
  const Collapse early = run_session(far, {}).collapse;
  CHECK_FALSE(early.imminent);
  CHECK(early.judged);
  CHECK(early.kind == CollapseKind::none);
}
