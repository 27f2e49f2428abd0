// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/servo_search.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::lab;

namespace {

constexpr int kTurn = 60, kLast = 100;

/// At held q, valve closed: the cell takes 300 Pa off a reading, u turns at kTurn.
PathHistory closed(double search, double bend = 4) {
  PathHistory history;
  for (int i = 0; i <= kLast; ++i) {
    PathSample sample;
    auto& s = sample.signal;
    const double pore = 400e3 + bend * (std::pow(i - kTurn, 2) - kTurn * kTurn);
    s[PathSample::reading] = s[PathSample::progress] = i;
    s[PathSample::q] = 180e3 + (i % 2 == 0 ? search : -search);
    s[PathSample::pore_pressure] = pore;
    s[PathSample::p_eff] = 350e3 - 300.0 * i + (400e3 - pore);
    history.add(sample);
  }
  return history;
}

double end_of(const PathHistory& history) {
  return end_of_search(history, {180e3, 350e3, 400e3}, kTurn, kLast);
}

}  // namespace

TEST_CASE("a loop that does not search leaves the trend to be seen at once") {
  CHECK(end_of(closed(0)) <= kTurn + 1);
}

TEST_CASE("the larger the search, the longer nobody can say whose increments were followed") {
  const double little = end_of(closed(30)), more = end_of(closed(60));
  CHECK(little > kTurn + 1);
  CHECK(more > little);
  CHECK(more < kLast);
  CHECK(end_of(closed(1000)) == kLast);
}

TEST_CASE("where u never fell the compliance is not known, and the search counts up to the end") {
  CHECK(end_of_search(closed(1), {180e3, 350e3, 300e3}, kTurn, kLast) == kLast);
}

TEST_CASE("the work of a search goes with the square of the scatter, and p' is its stiffness") {
  CHECK(work_of_search(200, 100e3) == Approx(4 * work_of_search(100, 100e3)));
  CHECK(work_of_search(200, 200e3) == Approx(work_of_search(200, 100e3) / 2));
  CHECK(work_of_search(100, 100e3) == Approx(std::pow(2.2 * 100, 2) * 2 / 1.5 / 100e3));
}
