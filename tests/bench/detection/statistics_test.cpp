// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/statistics.hpp"

#include <catch2/catch.hpp>

using namespace triax::bench;

TEST_CASE("a quantile is the value that its share of the values does not exceed") {
  std::vector<double> hundred;
  for (int i = 100; i >= 1; --i) hundred.push_back(i);
  CHECK(quantile(hundred, 0.5) == 50);
  CHECK(quantile(hundred, 0.95) == 95);
  CHECK(quantile(hundred, 1) == 100);
  CHECK(quantile({7}, 0.5) == 7);
  CHECK(quantile({1, 2, 3}, 0.5) == 2);
  CHECK(quantile({1, 2, 3}, 0.95) == 3);
  CHECK_FALSE(quantile({}, 0.5));
}

TEST_CASE("detection counts among the collapsing, false alarms among the controls") {
  std::vector<Outcome> outcomes;
  for (int i = 0; i < 4; ++i) {
    Outcome o{.collapses = true, .detected = i != 3};
    if (o.detected) {
      o.eta_error = 0.01 * (i + 1);
      o.delay = -i;
      o.notice_delay = 10 * i;
    }
    outcomes.push_back(o);
  }
  for (int i = 0; i < 10; ++i) outcomes.push_back({.collapses = false, .detected = i == 0});
  const Summary s = summarise(outcomes);
  CHECK(s.detection() == Approx(0.75));
  CHECK(s.false_alarm() == Approx(0.1));
  CHECK(*s.eta_error.half == Approx(0.02));
  CHECK(*s.eta_error.all == Approx(0.03));
  CHECK(s.delay.all == 2);  // too early counts as much as too late
  CHECK(s.notice_delay.half == 10);
  CHECK(s.unnoticed == 1);  // the one that was not detected either; no control is counted
}

TEST_CASE("without tests of a kind nothing is missed and nothing is false") {
  const Summary s = summarise({});
  CHECK(s.detection() == 1);
  CHECK(s.false_alarm() == 0);
  CHECK_FALSE(s.eta_error.half);
}
