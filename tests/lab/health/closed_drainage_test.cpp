// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/closed_drainage.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

using namespace triax::lab;

namespace {

constexpr double kVolume_m3 = 5e-4;

/// An undrained stage as its instruments show it: the excess pore pressure, kPa, of each reading,
/// and whatever else is done to the reading; q and p′ are not known at readings that are `blind`. q
/// grows by 1 kPa a reading, p′ starts at 100 kPa.
struct WatchedDrainage {
  ClosedDrainage drainage{kVolume_m3};
  std::vector<std::int64_t> marks;
  std::optional<std::int64_t> known_at;

  WatchedDrainage(
      std::int64_t n, const std::function<double(std::int64_t)>& excess_kPa,
      const std::function<void(Reading&)>& spoil = [](Reading&) {},
      const std::function<bool(std::int64_t)>& blind = [](std::int64_t) { return false; }) {
    for (std::int64_t i = 0; i < n; ++i) {
      Reading r;
      r.number = i;
      r.stage = 3;
      r[Quantity::cell_pressure] = 400e3;
      r[Quantity::back_pressure] = 300e3;
      r[Quantity::pore_pressure] = 300e3 + 1e3 * excess_kPa(i);
      r[Quantity::back_volume] = -2e-6;
      spoil(r);
      State s;
      s.q = 1e3 * double(i);
      s.p_eff = 400e3 - r[Quantity::pore_pressure] + s.q / 3;
      if (blind(i)) s.q = s.p_eff = kMissing;
      drainage.add(r, s);
      if (drainage.is_mark()) marks.push_back(i);
      if (doubt() && !known_at) known_at = i;
    }
  }
  std::optional<ClosedDrainage::Doubt> doubt() const {
    return drainage.doubt() ? drainage.doubt() : drainage.suspicion();
  }
  std::string reason() const { return doubt() ? doubt()->reason : ""; }
};

/// Rises by 1 kPa a reading up to 60; then, through an open valve, back within a few readings.
double until_opened(std::int64_t i) {
  return i <= 60 ? double(i) : 60 * std::exp(-double(i - 60) / 4);
}

}  // namespace

TEST_CASE("an undrained specimen is not doubted: contracting, dilating, coming to rest") {
  CHECK_FALSE(WatchedDrainage(500, [](auto i) { return double(i) / 6; }).doubt());
  // It contracts, then dilates past the back pressure.
  CHECK_FALSE(WatchedDrainage(500, [](auto i) {
                return 40 * std::sin(double(i) / 40) - 0.2 * double(i);
              }).doubt());
  // It flows: u comes near the cell pressure and stays.
  CHECK_FALSE(
      WatchedDrainage(500, [](auto i) { return 95 * (1 - std::exp(-double(i) / 50)); }).doubt());
  // It dilates to a critical state at a third of the largest excess.
  CHECK_FALSE(WatchedDrainage(500, [](auto i) {
                return i < 60 ? double(i) : 20 + 40 * std::exp(-double(i - 60) / 20);
              }).doubt());
}

TEST_CASE("water through a closed valve ends it at the last dry reading") {
  const auto drips = [](double rate) {
    return [rate](Reading& r) {
      if (r.number > 100) r[Quantity::back_volume] += rate * double(r.number - 100);
    };
  };
  const auto excess = [](auto i) { return double(i) / 4; };
  // The limit is 250 mm³: it is passed at reading 111, and believed with the next.
  const WatchedDrainage leaks(200, excess, drips(24e-9));
  REQUIRE(leaks.doubt());
  CHECK(leaks.doubt()->last == 110);
  CHECK(leaks.known_at == 112);
  CHECK(leaks.reason().find("water flows although the valve is closed (288 mm3)") == 0);
  CHECK(WatchedDrainage(200, excess, drips(-24e-9)).doubt()->last == 110);
  CHECK_FALSE(WatchedDrainage(200, excess, drips(2.4e-9)).doubt());
}

TEST_CASE("a single stray volume is no water, but nothing is known at it") {
  const WatchedDrainage stray(
      101, [](auto i) { return double(i) / 4; },
      [](Reading& r) {
        if (r.number == 50 || r.number == 100) r[Quantity::back_volume] += 1e-6;
      });
  CHECK_FALSE(stray.doubt());
  CHECK(stray.drainage.wet());
}

TEST_CASE("a pore pressure that comes back to the back pressure and stays: the valve has opened") {
  const WatchedDrainage opened(120, until_opened);
  REQUIRE(opened.doubt());
  CHECK(opened.doubt()->last == 60);
  CHECK(opened.reason().find("from 60.0 kPa away") != std::string::npos);
  // The doubt reaches back to a mark, that was set at once.
  CHECK(opened.marks == std::vector<std::int64_t>{0, 61});
  CHECK(*opened.known_at > 75);
  // While it is on its way nothing is said, nor where it passes by.
  CHECK_FALSE(WatchedDrainage(70, until_opened).doubt());
  CHECK_FALSE(WatchedDrainage(500, [](auto i) {
                return i <= 60 ? double(i) : 60 - 0.7 * double(i - 60);
              }).doubt());
}

TEST_CASE("it need not come all the way back, where it then no longer answers to the load") {
  // Water runs on through the valve: a sixth of the largest remains, and grows slowly.
  const auto flows = [](std::int64_t i) {
    return i <= 60 ? double(i) : 10 + 0.01 * double(i) + 50 * std::exp(-double(i - 60) / 4);
  };
  const WatchedDrainage near(200, flows);
  REQUIRE(near.doubt());
  CHECK(near.doubt()->last == 60);
  // Near from about reading 67; 15 kPa of p later:
  CHECK(std::abs(*near.known_at - 115) <= 5);
  CHECK_FALSE(WatchedDrainage(100, flows).doubt());
  // A specimen that dilates slowly near the back pressure answers to the load.
  CHECK_FALSE(WatchedDrainage(500, [](auto i) {
                return i <= 60 ? double(i) : 60 - 0.2 * double(i - 60);
              }).doubt());
}

TEST_CASE("a volume gauge that comes late does not move the end to when it came") {
  const WatchedDrainage late(85, until_opened, [](Reading& r) {
    if (r.number > 67) r[Quantity::back_volume] -= 1e-6;
  });
  REQUIRE(late.doubt());
  CHECK(late.known_at == 69);
  CHECK(late.doubt()->last == 60);
}

TEST_CASE("a pore pressure that does not answer: the valve never closed") {
  // q grows by 1 kPa a reading, p by a third: 15 kPa are reached at reading 45.
  const WatchedDrainage silent(200, [](auto i) { return 0.01 * double(i % 3); });
  REQUIRE(silent.doubt());
  CHECK(silent.known_at == 45);
  CHECK(silent.doubt()->last == -1);
  CHECK(silent.reason().find("stayed at the back pressure") != std::string::npos);
  CHECK_FALSE(WatchedDrainage(44, [](auto) { return 0.0; }).doubt());
  // Once it has answered it may come near again; B = 0.3 is an answer.
  CHECK_FALSE(WatchedDrainage(200, [](auto i) { return 0.1 * double(i); }).doubt());
  // Zeros that differ are no answer.
  CHECK(WatchedDrainage(200, [](auto) { return 20.0; }).doubt());
}

TEST_CASE("a pore pressure that leaves the back pressure after all lifts the suspicion") {
  // Air in the pores: u rests while p′ falls by half, and leaves where the specimen collapses.
  const auto late = [](std::int64_t i) { return i < 150 ? 0.0 : double(i - 150); };
  CHECK(WatchedDrainage(155, late).doubt()->last == -1);
  const WatchedDrainage collapsed(160, late);
  CHECK_FALSE(collapsed.doubt());
  // What was found before the valve was shut need not be kept any more, until the next turn.
  CHECK(collapsed.marks == std::vector<std::int64_t>{0});
  // It came back to rest near the back pressure, and goes on to the other side.
  const auto passes = [](std::int64_t i) {
    if (i <= 60) return -double(i);
    return i < 120 ? -60 * std::exp(-double(i - 60) / 4) : double(i - 120);
  };
  REQUIRE(WatchedDrainage(120, passes).doubt());
  CHECK(WatchedDrainage(139, passes).doubt()->last == 60);  // a third of 60 kPa is reached at 141
  CHECK_FALSE(WatchedDrainage(145, passes).doubt());
  // A doubt by water is for good.
  const WatchedDrainage wet(300, late, [](Reading& r) {
    if (r.number > 100) r[Quantity::back_volume] += 1e-6;
  });
  CHECK(wet.drainage.doubt()->last == 100);
}

TEST_CASE("a dead sensor of the back pressure leaves its last value; a dead gauge the other") {
  const auto without = [](Quantity q, std::int64_t from) {
    return [q, from](Reading& r) {
      if (r.number >= from) r[q] = kMissing;
    };
  };
  CHECK(WatchedDrainage(120, until_opened, without(Quantity::back_volume, 0)).doubt()->last == 60);
  for (const std::int64_t from : {0, 30})
    CHECK(
        WatchedDrainage(120, until_opened, without(Quantity::back_pressure, from)).doubt()->last ==
        60);
  CHECK_FALSE(WatchedDrainage(120, until_opened, without(Quantity::pore_pressure, 0)).doubt());
}

TEST_CASE("stresses that are not known are no load, and hide none") {
  const auto still = [](std::int64_t) { return 0.0; };
  const auto nothing = [](Reading&) {};
  CHECK_FALSE(WatchedDrainage(200, still, nothing, [](auto i) { return i >= 30; }).doubt());
  // What it started from is that of the first reading at which it is known.
  const WatchedDrainage late(200, still, nothing, [](auto i) { return i < 10; });
  REQUIRE(late.doubt());
  CHECK(late.known_at == 57);  // p′ is 103.3 kPa by then, 15 % of it 15.5 kPa
  CHECK(late.doubt()->last == -1);
  // One in seven is not known: that u no longer answers shows all the same.
  const auto flows = [](std::int64_t i) {
    return i <= 60 ? double(i) : 10 + 0.01 * double(i) + 50 * std::exp(-double(i - 60) / 4);
  };
  const WatchedDrainage near(200, flows, nothing, [](auto i) { return i % 7 == 0; });
  REQUIRE(near.doubt());
  CHECK(near.doubt()->last == 60);
  CHECK(std::abs(*near.known_at - 115) <= 5);
}

TEST_CASE("an open valve wipes the slate clean") {
  WatchedDrainage silent(60, [](auto) { return 0.0; });
  REQUIRE(silent.doubt());
  silent.drainage.open();
  CHECK_FALSE(silent.doubt());
  CHECK_FALSE(silent.drainage.wet());
}
