// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/live/live_tests.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <future>
#include <thread>

#include "db/recording/recorder.hpp"
#include "db/store.hpp"
#include "src/page/api/programme_form.hpp"
#include "src/page/request/request.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using namespace triax::src;

namespace {

constexpr std::chrono::seconds kPatience{30};

/// Takes what comes until `enough`; fails where that does not come.
template <class Enough>
std::vector<LiveItem> taken_until(LiveFeed& feed, LiveFeed::Cursor& cursor, const Enough& enough) {
  std::vector<LiveItem> all;
  const auto until = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < until) {
    const LiveTaken taken = feed.take(cursor, 100);
    all.insert(all.end(), taken.items.begin(), taken.items.end());
    if (enough(all, taken)) return all;
    if (taken.items.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  FAIL("it did not come");
  return all;
}

bool is_over(const std::vector<LiveItem>&, const LiveTaken& taken) { return taken.over; }

auto is_event(lab::EventKind kind) {
  return [kind](const std::vector<LiveItem>& all, const LiveTaken&) {
    return std::ranges::any_of(all, [kind](const LiveItem& item) {
      const auto* event = std::get_if<lab::Event>(&item.what);
      return event && event->kind == kind;
    });
  };
}

std::vector<std::int64_t> readings_of(const std::vector<LiveItem>& items) {
  std::vector<std::int64_t> numbers;
  for (const LiveItem& item : items)
    if (const auto* one = std::get_if<LiveReading>(&item.what))
      numbers.push_back(one->reading.number);
  return numbers;
}

RunAsked asked(double speed) {
  RunAsked run;
  run.programme = programme_of("icu_6", {});
  run.speed = speed;
  return run;
}

std::vector<lab::EventKind> kinds_of_orders(const db::StoredTest& test) {
  std::vector<lab::EventKind> kinds;
  for (const lab::Event& event : test.events)
    if (event.detail.starts_with("by ")) kinds.push_back(event.kind);
  return kinds;
}

}  // namespace

TEST_CASE("a run is held, goes on and is stopped, each an event of the record with who and when") {
  const triax::testing::TemporaryFolder folder;
  const std::string path = folder.file("run.db");
  LiveTests tests(path);
  const std::int64_t id = tests.run(asked(600));
  const auto feed = tests.feed_of(id);
  LiveFeed::Cursor cursor;
  const auto first =
      taken_until(*feed, cursor, [](const auto& all, auto&) { return all.size() > 20; });
  CHECK(tests.control_of(id).controlled);
  CHECK_THROWS_AS(tests.order(id, {RunOrder::Kind::resume, "Anna"}), Refused);
  tests.order(id, {RunOrder::Kind::hold, "Anna"});
  taken_until(*feed, cursor, is_event(lab::EventKind::held));
  CHECK(tests.control_of(id).held);
  CHECK_THROWS_AS(tests.order(id, {RunOrder::Kind::hold, "Ben"}), Refused);
  tests.order(id, {RunOrder::Kind::resume, "Ben"});
  taken_until(*feed, cursor, is_event(lab::EventKind::resumed));
  tests.order(id, {RunOrder::Kind::stop, "Carla"});
  taken_until(*feed, cursor, is_over);
  CHECK_THROWS_AS(tests.order(id, {RunOrder::Kind::hold, "Anna"}), Refused);
  const auto stored = db::Store(path).load(id);
  CHECK(stored.status == db::TestStatus::complete);
  using enum lab::EventKind;
  CHECK(kinds_of_orders(stored) == std::vector{held, resumed, aborted});
}

TEST_CASE("a run that is held as fast as it can does not fill the disk") {
  const triax::testing::TemporaryFolder folder;
  LiveTests tests(folder.file("held.db"));
  // Scans so dense that it is not over before it can be held.
  RunAsked run = asked(0);
  run.programme = programme_of("icu_6", {{"test.scan_interval_s", "0.01"}});
  const std::int64_t id = tests.run(std::move(run));
  const auto feed = tests.feed_of(id);
  LiveFeed::Cursor cursor;
  feed->take(cursor, 1);  // where it is by now
  tests.order(id, {RunOrder::Kind::hold, "Anna"});
  taken_until(*feed, cursor, is_event(lab::EventKind::held));
  REQUIRE(tests.control_of(id).held);
  taken_until(*feed, cursor, [](auto&, const LiveTaken& taken) { return taken.items.empty(); });
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const LiveTaken taken = feed->take(cursor, 500);
  CHECK_FALSE(taken.missed);
  CHECK_FALSE(taken.over);
  CHECK(readings_of(taken.items).size() <= 8);
}

TEST_CASE("all that run are stored when the page ends, and nothing begins any more") {
  const triax::testing::TemporaryFolder folder;
  const std::string path = folder.file("end.db");
  std::int64_t id = 0;
  {
    LiveTests tests(path);
    id = tests.run(asked(60));
    tests.end();
    CHECK_THROWS_AS(tests.run(asked(60)), Refused);
  }
  CHECK(db::Store(path).load(id).status == db::TestStatus::complete);
}

TEST_CASE("what cannot run is told, and leaves nothing") {
  const triax::testing::TemporaryFolder folder;
  LiveTests tests(folder.file("none.db"));
  RunAsked run = asked(0);
  run.rig = folder.file("none.toml");
  CHECK_THROWS(tests.run(std::move(run)));
  CHECK(folder.is_empty());
}

TEST_CASE("a test that another program records is told reading by reading, to its end") {
  const triax::testing::TemporaryFolder folder;
  const std::string path = folder.file("watch.db");
  db::Recorder recorder(path);
  const auto listener = recorder.listener();
  listener.started(triax::testing::raw_header("watched"));
  triax::testing::send_scans(listener, 0, 12000);  // more than a batch: it enters
  std::int64_t id = 0;
  const auto until = std::chrono::steady_clock::now() + kPatience;
  while (id == 0 && std::chrono::steady_clock::now() < until) try {
      id = db::Store(path).find({"watched"}).front();
    } catch (const std::exception&) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  REQUIRE(id == 1);
  LiveTests tests(path);
  const auto feed = tests.feed_of(id);
  CHECK_FALSE(tests.control_of(id).controlled);
  LiveFeed::Cursor cursor;
  cursor.after = LivePosition{11990, 0};
  auto items = taken_until(*feed, cursor, [](const auto& all, auto&) {
    return !all.empty() && all.back().at.reading >= 11999;
  });
  triax::testing::send_scans(listener, 12000, 500);
  lab::Event event;
  event.kind = lab::EventKind::loss_of_sustainability;
  event.reading = 12100;
  event.detail = "told late";
  event.detected_at = lab::Moment{12499, {}};
  listener.happened(event);
  recorder.finish({});
  const auto rest = taken_until(*feed, cursor, is_over);
  items.insert(items.end(), rest.begin(), rest.end());
  const auto numbers = readings_of(items);
  REQUIRE(numbers.size() == 509);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    REQUIRE(numbers[i] == 11991 + static_cast<std::int64_t>(i));
  const auto told = std::ranges::count_if(items, [](const LiveItem& item) {
    const auto* one = std::get_if<lab::Event>(&item.what);
    return one && one->detail == "told late";
  });
  CHECK(told == 1);
  REQUIRE(std::holds_alternative<LiveEnd>(items.back().what));
  CHECK(std::get<LiveEnd>(items.back().what).status == "complete");
}

TEST_CASE("who comes back to a watched test from before its tail is told what was missed") {
  const triax::testing::TemporaryFolder folder;
  const std::string path = folder.file("tail.db");
  db::Recorder recorder(path);
  std::promise<std::int64_t> entered;
  recorder.when_entered([&entered](std::int64_t id) { entered.set_value(id); });
  const auto listener = recorder.listener();
  listener.started(triax::testing::raw_header("watched"));
  triax::testing::send_scans(listener, 0, 12000);  // more than a batch, and than the tail
  REQUIRE(entered.get_future().get() == 1);
  const auto came_back = [&path] {
    LiveTests tests(path);
    LiveFeed::Cursor cursor;
    cursor.after = LivePosition{100, 0};
    return tests.feed_of(1)->take(cursor, 100);  // at once
  };
  auto taken = came_back();
  // What is recorded reaches the database in its own time, batch by batch.
  for (int i = 0; i < 300 && !taken.missed; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    taken = came_back();
  }
  REQUIRE(taken.missed);
  CHECK(taken.missed->first == 101);
  CHECK(taken.missed->second > 101);
  recorder.finish({});
}

TEST_CASE("a test that is over has a stream that says so") {
  const triax::testing::TemporaryFolder folder;
  const std::string path = folder.file("over.db");
  {
    db::Recorder recorder(path);
    const auto listener = recorder.listener();
    listener.started(triax::testing::raw_header("over"));
    triax::testing::send_scans(listener, 0, 5);
    recorder.finish({});
  }
  LiveTests tests(path);
  LiveFeed::Cursor cursor;
  cursor.after = LivePosition{4, 0};
  const auto taken = tests.feed_of(1)->take(cursor, 10);
  CHECK(taken.over);
  CHECK_THROWS(tests.feed_of(2));
}
