// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/gaps.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

SecondOrderWorkPoint point(std::int64_t reading, double work, double error = 0.01) {
  SecondOrderWorkPoint p;
  p.reading = reading;
  p.work.normalised = work;
  p.normalised_error = error;
  p.window_readings = 8;
  return p;
}

Collapse collapse_at(std::int64_t reading) {
  Collapse c;
  c.kind = CollapseKind::flow;
  c.onset = Instant{.reading = reading};
  return c;
}

}  // namespace

TEST_CASE("without a gap, or before it, an onset is where it was found") {
  Gaps gaps;
  CHECK_FALSE(gaps.caveat(collapse_at(500)));
  gaps.end(600);
  CHECK_FALSE(gaps.caveat(collapse_at(599)));
  CHECK_FALSE(gaps.caveat(Collapse()));
}

TEST_CASE("after a gap it may lie before, until the work was seen to be positive") {
  Gaps gaps;
  gaps.end(600);
  gaps.add(point(590, 0.5));    // of before the gap
  gaps.add(point(610, -0.5));   // no longer sustained
  gaps.add(point(615, 0.005));  // not known from zero
  CHECK(gaps.caveat(collapse_at(600)) ==
        std::string("at or before reading 600: readings are missing before it"));
  CHECK(gaps.caveat(collapse_at(900)));
  gaps.add(point(700, 0.5));
  CHECK(gaps.caveat(collapse_at(704)));
  CHECK_FALSE(gaps.caveat(collapse_at(705)));
}

TEST_CASE("each gap counts by itself, the oldest are forgotten") {
  Gaps gaps;
  gaps.end(600);
  gaps.add(point(700, 0.5));
  gaps.end(800);
  CHECK_FALSE(gaps.caveat(collapse_at(750)));
  CHECK(gaps.caveat(collapse_at(810)));
  for (std::size_t i = 0; i < Gaps::kKept; ++i) {
    gaps.end(1000 + 100 * static_cast<std::int64_t>(i));
    gaps.add(point(1050 + 100 * static_cast<std::int64_t>(i), 0.5));
  }
  CHECK_FALSE(gaps.caveat(collapse_at(810)));
}
