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
  void abort(const std::string& reason) override { aborted_for = reason; }

  std::string aborted_for;

 private:
  RecordHeader header_;
  int readings_, fails_at_, i_ = 0;
};

}  // namespace

TEST_CASE("signals carry every reading in order, and the summary says what they came to") {
  FakeRig rig(3000);
  Session session;
  std::int64_t scans = 0, points = 0;
  std::vector<std::string> events;
  QObject::connect(&session, &Session::scanned, [&](const Reading& r, const State& s) {
    REQUIRE(r.number == scans);
    REQUIRE(s.reading == scans);
    ++scans;
  });
  QObject::connect(&session, &Session::second_order_work, [&] { ++points; });
  QObject::connect(&session, &Session::happened, [&](const Event& e) { events.push_back(e.kind); });
  const TestSummary summary = session.run(rig, {});
  CHECK(scans == 3000);
  CHECK(summary.readings == 3000);
  CHECK(points > 100);
  CHECK(events == std::vector<std::string>{"stage_started", "loss_of_sustainability"});
  CHECK(summary.collapse.kind == CollapseKind::flow);
  CHECK(std::abs(summary.collapse.onset->reading - 400) < 8);
  CHECK(std::abs(summary.peak->reading - 400) < 8);
}

TEST_CASE("speed changes nothing but the time it takes") {
  const auto run = [](double speed) {
    FakeRig rig(1000);
    Session session;
    std::vector<double> states;
    QObject::connect(&session, &Session::scanned, [&](const Reading&, const State& s) {
      states.insert(states.end(), {s.q, s.p_eff, s.strain.axial});
    });
    session.run(rig, {.speed = speed});
    return states;
  };
  CHECK(run(0) == run(5000));
}

TEST_CASE("a test that is stopped is judged as far as it went and says when") {
  FakeRig rig(3000);
  Session session;
  std::int64_t scans = 0;
  QObject::connect(&session, &Session::scanned, [&] { ++scans; });
  const TestSummary summary = session.run(rig, {.stop = [&] { return scans == 1500; }});
  CHECK(scans == 1500);
  CHECK(summary.readings == 1500);
  CHECK(summary.collapse.kind == CollapseKind::flow);
  CHECK(rig.aborted_for.find("aborted by the operator at ") == 0);
  REQUIRE_FALSE(summary.warnings.empty());
  CHECK(summary.warnings[0].text == rig.aborted_for);
}

TEST_CASE("a stop is heard while the clock is waited for") {
  FakeRig rig(1000);
  Session session;
  const auto start = std::chrono::steady_clock::now();
  const auto since = [&] { return std::chrono::steady_clock::now() - start; };
  const TestSummary summary = session.run(
      rig, {.speed = 0.01, .stop = [&] { return since() > std::chrono::milliseconds(250); }});
  CHECK(since() < std::chrono::seconds(5));
  CHECK(summary.readings < 10);
}

TEST_CASE("a back end that fails leaves the signalled readings standing") {
  FakeRig rig(1000, 500);
  Session session;
  int scans = 0;
  QObject::connect(&session, &Session::scanned, [&] { ++scans; });
  CHECK_THROWS_AS(session.run(rig, {}), BadInput);
  CHECK(scans == 500);
}
