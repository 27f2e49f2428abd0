// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/live/live_feed.hpp"

#include <catch2/catch.hpp>

using namespace triax;
using src::LiveFeed;

namespace {

void scan(LiveFeed& feed, std::int64_t number) {
  lab::Reading reading;
  reading.number = number;
  feed.scanned(reading, lab::State{});
}

std::vector<std::string> places(const src::LiveTaken& taken) {
  std::vector<std::string> all;
  for (const auto& item : taken.items) all.push_back(to_string(item.at));
  return all;
}

using Places = std::vector<std::string>;

}  // namespace

TEST_CASE("places are a reading's number and what was told behind it") {
  CHECK(src::live_position("17") == src::LivePosition{17, 0});
  CHECK(src::live_position("17.2") == src::LivePosition{17, 2});
  CHECK(src::live_position("-1.1") == src::LivePosition{-1, 1});
  for (const char* bad : {"", "x", "-2", "1.", "1.-1", ".1", "1 ", "1.1.1"})
    CHECK_FALSE(src::live_position(bad));
}

TEST_CASE("a browser that comes back goes on without a gap or a double") {
  LiveFeed feed;
  feed.happened({});
  scan(feed, 0);
  feed.happened({});
  feed.happened({});
  scan(feed, 1);
  LiveFeed::Cursor first;
  CHECK(places(feed.take(first, 3)) == Places{"-1.1", "0", "0.1"});
  LiveFeed::Cursor again{.after = src::live_position("0.1"), .next = {}};
  CHECK(places(feed.take(again, 10)) == Places{"0.2", "1"});
  CHECK(places(feed.take(again, 10)).empty());
  scan(feed, 2);
  CHECK(places(feed.take(again, 10)) == Places{"2"});
  CHECK(places(feed.take(first, 10)) == Places{"0.2", "1", "2"});
}

TEST_CASE("what a slow browser cannot take is dropped for it, and told") {
  LiveFeed feed(4);
  LiveFeed::Cursor slow;
  scan(feed, 0);
  CHECK(places(feed.take(slow, 10)) == Places{"0"});
  for (int i = 1; i <= 10; ++i) scan(feed, i);
  const auto taken = feed.take(slow, 10);
  CHECK(taken.items.empty());
  REQUIRE(taken.missed);
  CHECK(*taken.missed == std::pair<std::int64_t, std::int64_t>{1, 10});
  scan(feed, 11);
  const auto more = feed.take(slow, 10);
  CHECK(places(more) == Places{"11"});
  CHECK_FALSE(more.missed);
  // Who asks for nothing that is gone misses nothing.
  LiveFeed::Cursor fresh{.after = src::live_position("9"), .next = {}};
  CHECK(places(feed.take(fresh, 10)) == Places{"10", "11"});
}

TEST_CASE("the end is told also to who comes after it, and nothing behind it") {
  LiveFeed feed(2);
  for (int i = 0; i < 5; ++i) scan(feed, i);
  feed.ended("complete");
  scan(feed, 5);
  LiveFeed::Cursor late;
  const auto taken = feed.take(late, 10);
  CHECK(taken.missed);
  CHECK(places(taken) == Places{"4.1"});
  CHECK(taken.over);
  LiveFeed::Cursor again{.after = src::live_position("4.1"), .next = {}};
  CHECK(feed.take(again, 10).over);
}

TEST_CASE("listeners are woken once until somebody takes") {
  LiveFeed feed;
  int woken = 0;
  const auto number = feed.listen([&] { ++woken; });
  scan(feed, 0);
  scan(feed, 1);
  CHECK(woken == 1);
  LiveFeed::Cursor cursor;
  feed.take(cursor, 10);
  scan(feed, 2);
  CHECK(woken == 2);
  feed.forget(number);
  feed.take(cursor, 10);
  scan(feed, 3);
  CHECK(woken == 2);
}

TEST_CASE("the share done is told when it changes") {
  LiveFeed feed;
  LiveFeed::Cursor cursor;
  CHECK_FALSE(feed.take(cursor, 1).share);
  feed.progressed(0.25);
  CHECK(feed.take(cursor, 1).share == 0.25);
  CHECK_FALSE(feed.take(cursor, 1).share);
}

TEST_CASE("a stream that continues a test begins behind what the database has") {
  LiveFeed feed;
  feed.begin_behind(99);
  scan(feed, 100);
  LiveFeed::Cursor knows{.after = src::live_position("99"), .next = {}};
  CHECK(places(feed.take(knows, 10)) == Places{"100"});
  LiveFeed::Cursor knows_nothing;
  CHECK(feed.take(knows_nothing, 10).missed == std::pair<std::int64_t, std::int64_t>{0, 100});
}
