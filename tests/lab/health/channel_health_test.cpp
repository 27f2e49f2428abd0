// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/channel_health.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "lab/devices/noise.hpp"

using namespace triax::lab;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double live(std::int64_t i) {
  return std::round(0.2 * double(i) + 4 * standard_normal(3, 2, std::uint64_t(i)));
}

/// Feeds `n` readings of `value`, and checks at each that nothing said before is taken back: what
/// is found wrong was in doubt until then.
struct WatchedChannel {
  ChannelHealth health{1e-9, 1, 20};  // five times the noise of live() is worth a word
  std::int64_t number = 0;
  std::int64_t settled = 0;  ///< readings before this one were beyond doubt
  std::vector<ChannelHealth::Spike> spikes;

  void feed(std::int64_t n, const std::function<double(std::int64_t)>& value) {
    for (std::int64_t end = number + n; number < end; ++number) {
      const bool was_dead = health.dead().has_value();
      health.add(number, value(number));
      if (!was_dead && health.dead()) CHECK(health.dead()->from >= settled);
      if (health.spike()) {
        CHECK(health.spike()->from >= settled);
        spikes.push_back(*health.spike());
      }
      settled = std::min(health.doubtful_from(), number + 1);
    }
  }
};

}  // namespace

TEST_CASE("a live channel is found sound, and settled within a few readings") {
  WatchedChannel w;
  std::int64_t longest = 0;
  for (int i = 0; i < 100; ++i) {
    w.feed(100, live);
    longest = std::max(longest, w.number - w.settled);
  }
  CHECK_FALSE(w.health.dead());
  CHECK(w.spikes.empty());
  CHECK(longest <= 8);
}

TEST_CASE("stuck: from the first repeated value on, until it has moved again for good") {
  WatchedChannel w;
  w.feed(500, live);
  const double held = live(499);
  w.feed(100, [&](std::int64_t) { return held; });
  REQUIRE(w.health.dead());
  CHECK(w.health.dead()->fault == SensorFault::stuck);
  CHECK(w.health.dead()->from == 500);
  w.feed(5, live);
  CHECK(w.health.dead());
  w.feed(20, live);
  CHECK_FALSE(w.health.dead());
}

TEST_CASE("a jump out of all that was read, to a constant, is a saturated converter") {
  for (double rail : {32767.0, -32768.0}) {
    WatchedChannel w;
    w.feed(500, live);
    w.feed(sensor_limits::kStuckAfterJump.count() + 1, [&](std::int64_t) { return rail; });
    REQUIRE(w.health.dead());
    CHECK(w.health.dead()->fault == SensorFault::saturated);
    CHECK(w.health.dead()->from == 500);
  }
}

TEST_CASE("a jump to another level that goes on moving is no fault") {
  WatchedChannel w;
  w.feed(500, live);
  w.feed(500, [](std::int64_t i) { return 5000 + live(i); });
  CHECK_FALSE(w.health.dead());
  CHECK(w.spikes.empty());
}

TEST_CASE("missing: more than a few readings of a channel that was read at every scan") {
  const auto none = [](std::int64_t) { return kNone; };
  WatchedChannel w;
  w.feed(100, live);
  w.feed(sensor_limits::kMissing.count(), none);
  CHECK(w.health.absent());
  CHECK_FALSE(w.health.dead());
  w.feed(1, none);
  REQUIRE(w.health.dead());
  CHECK(w.health.dead()->fault == SensorFault::missing);
  CHECK(w.health.dead()->from == 100);
  w.feed(1, live);
  CHECK_FALSE(w.health.dead());
}

TEST_CASE("a channel that is read now and then only is not missed") {
  WatchedChannel w;
  w.feed(2000, [](std::int64_t i) { return i % 10 == 0 ? live(i) : kNone; });
  CHECK_FALSE(w.health.dead());
  CHECK_FALSE(w.health.absent());
}

TEST_CASE("spikes of one to three readings are found where they are, four are none") {
  for (int width = 1; width <= 4; ++width) {
    WatchedChannel w;
    w.feed(500, live);
    w.feed(width, [](std::int64_t i) { return live(i) - 800; });
    w.feed(100, live);
    INFO("width " << width);
    if (width > sensor_limits::kSpike.count()) {
      CHECK(w.spikes.empty());
      continue;
    }
    REQUIRE(w.spikes.size() == 1);
    CHECK(w.spikes[0].from == 500);
    CHECK(w.spikes[0].until == 499 + width);
    CHECK_FALSE(w.health.dead());
  }
}

TEST_CASE("a perfect ramp that ends at its target is at rest, not stuck") {
  WatchedChannel w;
  w.feed(3000, [](std::int64_t i) { return std::min(double(i) * 3.7, 3700.0); });
  CHECK_FALSE(w.health.dead());
  CHECK(w.spikes.empty());
}

TEST_CASE("what may rest is not called stuck, and what may not again only from then on") {
  WatchedChannel w;
  w.feed(500, live);
  w.health.may_rest(true);
  w.feed(300, [](std::int64_t) { return 100.0; });
  CHECK_FALSE(w.health.dead());
  w.health.may_rest(false);
  w.settled = w.number;
  w.feed(100, [](std::int64_t) { return 100.0; });
  REQUIRE(w.health.dead());
  CHECK(w.health.dead()->from == 800);
}

TEST_CASE("two spikes within three readings are left out with what is between them") {
  for (const std::int64_t apart : {1, 2}) {
    for (const double second : {500.0, -500.0}) {
      WatchedChannel w;
      w.feed(540, [&](std::int64_t i) {
        return live(i) + (i == 510 ? 500 : i == 510 + apart ? second : 0);
      });
      INFO(apart << " apart, the second of " << second);
      CHECK_FALSE(w.health.dead());
      REQUIRE(w.spikes.size() == 1);
      CHECK(w.spikes[0].from == 510);
      CHECK(w.spikes[0].until == 510 + apart);
    }
  }
}

TEST_CASE("a leap of which nobody learns whether it was a spike, for the channel dies, is dead") {
  const auto leap = [](std::int64_t i) { return live(i) + 500; };
  for (const double rest : {kNone, 32767.0}) {
    WatchedChannel w;
    w.feed(500, live);
    w.feed(1, leap);
    w.feed(sensor_limits::kStuckAfterJump.count() + 1, [&](std::int64_t) { return rest; });
    REQUIRE(w.health.dead());
    CHECK(w.health.dead()->from == 500);
  }
  // A spike long before is another matter.
  WatchedChannel w;
  w.feed(500, live);
  w.feed(1, leap);
  w.feed(19, live);
  w.feed(10, [](std::int64_t) { return kNone; });
  CHECK(w.spikes.size() == 1);
  CHECK(w.health.dead()->from == 520);
}

TEST_CASE("that a channel may rest from now on does not excuse the jump it rests after") {
  WatchedChannel w;
  w.feed(500, live);
  w.feed(5, [](std::int64_t) { return 32767.0; });
  w.health.may_rest(true);
  w.feed(sensor_limits::kStuckAfterJump.count() - 4, [](std::int64_t) { return 32767.0; });
  CHECK(w.health.jumped_at() == 500);
  CHECK(w.health.run() == sensor_limits::kStuckAfterJump.count());
  WatchedChannel quiet;
  quiet.feed(500, live);
  quiet.feed(5, [](std::int64_t) { return live(499); });
  quiet.health.may_rest(true);
  quiet.feed(3, [](std::int64_t) { return live(499); });
  CHECK(quiet.health.run() == 3);
}

TEST_CASE("what stands still since a jump, and then says nothing, was dead from the jump on") {
  WatchedChannel w;
  w.feed(100, live);
  w.feed(7, [](std::int64_t) { return 1e5; });
  w.feed(10, [](std::int64_t) { return kNone; });
  REQUIRE(w.health.dead());
  CHECK(w.health.dead()->fault == SensorFault::missing);
  CHECK(w.health.dead()->from == 100);
  CHECK(w.spikes.empty());
}

namespace {

/// A record of few readings without noise, `broken` where `value` is left.
WatchedChannel feed_curve(std::int64_t n, const std::function<double(std::int64_t)>& value) {
  WatchedChannel w;
  w.feed(n, value);
  return w;
}

double hardening(std::int64_t i) { return 100.0 * double(i) / (double(i) + 8); }

}  // namespace

TEST_CASE("ChannelHealth: a spike in a short record without noise", "[health]") {
  for (const std::int64_t from : {4, 8, 19, 25}) {
    for (const std::int64_t width : {1, 2, 3}) {
      for (const double value : {0.0, 250.0}) {
        INFO("from " << from << ", " << width << " readings of " << value);
        const auto w = feed_curve(40, [&](std::int64_t i) {
          return i >= from && i < from + width ? value : hardening(i);
        });
        REQUIRE(w.spikes.size() == 1);
        CHECK(w.spikes[0].from == from);
        CHECK(w.spikes[0].until == from + width - 1);
        CHECK(w.spikes[0].certain == (from > 16));
      }
    }
  }
}

TEST_CASE("ChannelHealth: a run of one value between two of one level", "[health]") {
  for (const double value : {0.0, 250.0}) {
    const auto w =
        feed_curve(40, [&](std::int64_t i) { return i >= 20 && i < 30 ? value : hardening(i); });
    REQUIRE(w.spikes.size() == 1);
    CHECK(w.spikes[0].from == 20);
    CHECK(w.spikes[0].until == 29);
    CHECK_FALSE(w.spikes[0].certain);
    CHECK(w.health.leaped_at(20));
    CHECK_FALSE(w.health.leaped_at(19));
  }
}

TEST_CASE("ChannelHealth: a first value that nothing leads to", "[health]") {
  const auto first = [](double value, std::int64_t readings, auto curve) {
    const auto w =
        feed_curve(30, [&](std::int64_t i) { return i < readings ? value : curve(double(i)); });
    CHECK(w.spikes.size() <= 1);
    return w.spikes.empty() ? -1 : w.spikes[0].until;
  };
  const auto harden = [](double i) { return 100 * i / (i + 8); };
  const auto decay = [](double i) { return 60 + 40 * std::exp(-i / 0.7); };
  CHECK(first(250, 1, harden) == 0);
  CHECK(first(130, 10, harden) == 9);
  CHECK(first(0, 0, harden) == -1);
  CHECK(first(0, 0, decay) == -1);
  CHECK(first(100, 20, harden) == -1);  // at rest for longer
}

TEST_CASE("ChannelHealth: a fall that lasts is no spike", "[health]") {
  for (const double after : {0.0, 5.0}) {
    auto w = feed_curve(
        40, [&](std::int64_t i) { return i < 20 ? hardening(i) : after + 0.01 * double(i % 3); });
    CHECK(w.spikes.empty());
    w.health.finish(39);
    CHECK_FALSE(w.health.spike());
  }
}

TEST_CASE("ChannelHealth: exactly zero until the record ends is a dropout", "[health]") {
  auto w = feed_curve(40, [&](std::int64_t i) { return i < 37 ? hardening(i) : 0.0; });
  CHECK(w.spikes.empty());
  w.health.finish(39);
  REQUIRE(w.health.spike());
  CHECK(w.health.spike()->from == 37);
  CHECK(w.health.spike()->until == 39);
}

TEST_CASE("ChannelHealth: a pressure that is printed as it was set may rest, not after a jump") {
  const auto rests_at = [](double value, bool printed_as_set) {
    ChannelHealth health{1e-9, 2, 20, printed_as_set};
    std::int64_t i = 0;
    for (; i < 500; ++i) health.add(i, live(i));
    for (; i < 800; ++i) health.add(i, value);
    return health.dead().has_value();
  };
  const double near = std::round(0.2 * 500) + 1;
  CHECK(rests_at(near, false));
  CHECK_FALSE(rests_at(near, true));
  CHECK(rests_at(near + 1e4, true));
}
