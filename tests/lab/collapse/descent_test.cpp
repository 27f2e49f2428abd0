// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/descent.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

/// Feeds points of given work and q, one window apart.
class Feed {
 public:
  void operator()(double work, double q, double error = 0.03) {
    PathPoint p;
    p.reading = 7.0 * count_++;
    p.q = q;
    p.p_eff = 100e3;
    p.axial_strain = 1e-3 * count_;
    p.work.normalised = work;
    p.normalised_error = error;
    p.window_readings = 7;
    tracker.add(p);
  }
  DescentTracker tracker;

 private:
  int count_ = 0;
};

}  // namespace

TEST_CASE("the onset lies where work vanishes, and what is lost while it is negative counts") {
  Feed feed;
  for (int i = 0; i < 10; ++i) feed(0.3, 90e3 + 1e3 * i);
  feed(0.1, 100e3);  // reading 70
  feed(-0.3, 99e3);  // reading 77: zero a quarter of the way
  for (int i = 1; i <= 8; ++i) feed(-0.3, 99e3 - 5e3 * i);
  const auto& d = feed.tracker.worst();
  REQUIRE(d);
  CHECK(d->onset.reading == Approx(70 + 7 * 0.25));
  CHECK(d->q_lost == Approx(41e3));
  CHECK(d->strength_loss() == Approx(0.41).epsilon(0.01));
  CHECK_FALSE(d->ended);
}

TEST_CASE("unloading with positive work costs no strength") {
  Feed feed;
  feed(0.1, 100e3);
  for (int i = 0; i < 3; ++i) feed(-0.3, 99e3 - 500.0 * i);
  for (int i = 0; i < 20; ++i) feed(0.8, 95e3 - 4e3 * i);
  REQUIRE(feed.tracker.worst());
  CHECK(feed.tracker.worst()->strength_loss() < 0.03);
  CHECK(feed.tracker.worst()->came_back);
}

TEST_CASE(
    "a new fall before half has come back goes on with the old descent; else it is a new one") {
  Feed feed;
  feed(0.1, 100e3);
  for (int i = 1; i <= 8; ++i) feed(-0.3, 100e3 - 5e3 * i);  // to 60
  for (int i = 1; i <= 8; ++i) feed(0.5, 60e3 + 1e3 * i);    // to 68: a fifth
  for (int i = 1; i <= 8; ++i) feed(-0.3, 68e3 - 4e3 * i);
  CHECK(feed.tracker.latest()->onset.q == Approx(100e3).epsilon(0.02));

  for (int i = 1; i <= 8; ++i) feed(0.5, 36e3 + 9e3 * i);  // to 108: all of it
  for (int i = 1; i <= 8; ++i) feed(-0.3, 108e3 - 3e3 * i);
  CHECK(feed.tracker.latest()->onset.q > 100e3);
  CHECK(feed.tracker.worst()->onset.q == Approx(100e3).epsilon(0.02));
}

TEST_CASE("points that say nothing neither begin nor end a descent") {
  Feed feed;
  feed(0.1, 100e3);
  for (int i = 0; i < 50; ++i) feed(-0.9, 100e3, 1.5);
  CHECK_FALSE(feed.tracker.worst());
}

TEST_CASE("a stage's start forgets what hangs between two stages") {
  Feed feed;
  feed(0.1, 100e3);
  feed(-0.1, 99e3, 0.05);  // not sure yet
  feed.tracker.start_stage({});
  for (int i = 1; i <= 5; ++i) feed(-0.3, 99e3 - 5e3 * i);
  REQUIRE(feed.tracker.latest());
  CHECK(feed.tracker.latest()->onset.reading >= 14);
}

TEST_CASE("a sharper onset goes with the descent; without one its own counts") {
  Feed feed;
  for (int i = 0; i < 10; ++i) feed(0.3, 90e3 + 1e3 * i);
  for (int i = 0; i < 9; ++i) feed(-0.3, 99e3 - 5e3 * i);
  const double coarse = feed.tracker.worst()->onset.reading;
  CHECK(feed.tracker.worst()->best_onset().reading == coarse);
  PathPoint sharp = feed.tracker.latest()->onset;
  sharp.reading = 68.5;
  feed.tracker.sharpen(sharp, StressInterval{{1, 2}, {3, 4}, {5, 6}});
  feed(-0.3, 50e3);
  CHECK(feed.tracker.worst()->best_onset().reading == 68.5);
  CHECK(feed.tracker.worst()->onset.reading == coarse);  // by which it is known
}

TEST_CASE("a descent is known once, and says between which windows it began") {
  Feed feed;
  for (int i = 0; i < 10; ++i) feed(0.3, 90e3 + 1e3 * i);  // the last at reading 63
  for (int i = 0; i < 6; ++i) feed(-0.3, 99e3 - 5e3 * i);
  REQUIRE(feed.tracker.latest());
  CHECK(feed.tracker.latest()->onset_low == 62);
  CHECK(feed.tracker.latest()->onset_high == 71);
  CHECK_FALSE(feed.tracker.worst()->noticed);
  feed.tracker.notice(Moment{100, 200.0});
  feed.tracker.notice(Moment{300, 600.0});
  feed(-0.3, 50e3);
  REQUIRE(feed.tracker.worst()->noticed);
  CHECK(feed.tracker.worst()->noticed->reading == 100);
}
