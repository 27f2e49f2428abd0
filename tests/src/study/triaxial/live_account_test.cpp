// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/live_account.hpp"

#include <catch2/catch.hpp>

#include "db/recording/recorder.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"
#include "tests/lab/measured/synthetic_path.hpp"

using namespace triax;

namespace {

lab::Forecast forecast_with_time_left(std::int64_t reading, double eta) {
  return {.reading = reading,
          .time_s = static_cast<double>(reading),
          .eta = eta,
          .eta_low = eta - 0.05,
          .eta_high = eta + 0.05,
          .left = lab::LeftToOnset{lab::Quantity::axial_strain, 0.001, 60.0}};
}

/// A test of 1000 readings whose stage begins with the first.
class ToldTest {
 public:
  std::vector<lab::Forecast> forecasts;
  std::vector<lab::Event> events = {{.reading = 0,
                                     .kind = lab::EventKind::stage_started,
                                     .detail = "stage 1",
                                     .detected_at = lab::Moment{0, 0.0}}};
  lab::Collapse collapse;

  study::LiveAccount account() const {
    db::Recorder recorder(folder_.file("t.db"));
    const lab::SessionListener listener = recorder.listener();
    listener.started(lab::testing::undrained_header());
    lab::testing::SyntheticPath path;
    for (int i = 0; i < 1000; ++i) {
      const lab::State state = path.state(i);
      lab::Reading reading;
      reading.number = i;
      reading.time_s = state.time_s;
      listener.scanned(reading, state);
    }
    for (const auto& o : forecasts) listener.foreseen(o);
    for (const auto& e : events) listener.happened(e);
    lab::TestSummary summary;
    summary.collapse = collapse;
    recorder.finish(summary);
    const db::Store store(folder_.file("t.db"));
    return study::live_account(store, store.load(1));
  }

 private:
  testing::TemporaryFolder folder_;
};

std::vector<std::int64_t> forecasts_at(const study::LiveAccount& account) {
  std::vector<std::int64_t> readings;
  for (const auto& row : account.rows)
    if (!row.event) readings.push_back(row.said->reading);
  return readings;
}

}  // namespace

TEST_CASE("of steady forecasts the first in every tenth up to the onset is told, and the last") {
  ToldTest test;
  for (int i = 95; i < 1000; i += 5) test.forecasts.push_back(forecast_with_time_left(i, 0.6));
  test.collapse.kind = lab::CollapseKind::flow;
  test.collapse.onset = lab::Instant{.reading = 399, .time_s = 399.0};
  const auto account = test.account();
  CHECK(forecasts_at(account) ==
        std::vector<std::int64_t>{95, 120, 160, 200, 240, 280, 320, 360, 395});
  CHECK(account.forecasts == 181);
  CHECK(account.shown == 9);
}

TEST_CASE("a forecast outside the interval of the one before is told; a wild one ends in a bound") {
  ToldTest test;
  for (int i = 5; i < 1000; ++i)
    test.forecasts.push_back(forecast_with_time_left(i, i == 27             ? 0.8
                                                        : i >= 500 && i % 2 ? 1.0
                                                                            : 0.6));
  const auto readings = forecasts_at(test.account());
  CHECK(std::ranges::count(readings, 27) == 1);
  CHECK(std::ranges::count(readings, 28) == 1);  // back again
  CHECK(readings.size() <= 12 + study::kMoves);
  CHECK(readings.size() >= 10 + study::kMoves);
}

TEST_CASE("events stand where they were known, levels with their forecast, the last without one") {
  ToldTest test;
  for (int i = 100; i < 300; i += 10) test.forecasts.push_back(forecast_with_time_left(i, 0.6));
  using enum lab::EventKind;
  test.events.push_back({100, 100.0, approaching, "near", lab::Moment{100, 100.0}});
  test.events.push_back({250, 250.0, limit_surface, "known at the end only", {}});
  test.events.push_back({240, 240.0, loss_of_sustainability, "fell", lab::Moment{290, 290.0}});
  test.collapse.kind = lab::CollapseKind::flow;
  test.collapse.onset = lab::Instant{.reading = 240, .time_s = 240.0};
  test.collapse.approaching = test.forecasts[0];
  const auto account = test.account();
  REQUIRE(account.rows.size() >= 4);
  CHECK(account.rows.front().event->kind == stage_started);
  const auto& level = account.rows[1];
  CHECK(level.event->kind == approaching);
  REQUIRE(level.forecast);
  CHECK(level.forecast->left->time_s == 60);
  CHECK(*level.eta == Approx(lab::testing::SyntheticPath{}.state(100).eta()));
  CHECK(level.stage == lab::testing::SyntheticPath{}.state(100).stage);
  CHECK(std::ranges::count(forecasts_at(account), 100) == 0);  // once is enough
  CHECK(account.rows[account.rows.size() - 2].event->kind == loss_of_sustainability);
  CHECK(account.rows.back().event->kind == limit_surface);
  CHECK_FALSE(account.rows.back().said);
  REQUIRE(account.approaching);
  CHECK(account.approaching->readings == 140);
  CHECK(account.approaching->time_s == 140);
  CHECK_FALSE(account.imminent);
}

TEST_CASE("without an onset nothing lies before it") {
  ToldTest test;
  test.forecasts.push_back(forecast_with_time_left(100, 0.6));
  test.collapse.approaching = test.forecasts[0];
  const auto account = test.account();
  CHECK_FALSE(account.onset);
  CHECK_FALSE(account.approaching);
}
