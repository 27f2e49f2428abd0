// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/time_line.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace triax::lab;

namespace {
struct StampedClock {
  std::vector<Warning> warnings;
  Findings findings{warnings};
  TimeLine line{true, false};
  std::vector<double> run(const std::vector<double>& stamps) {
    std::vector<double> out;
    for (const double stamp : stamps)
      out.push_back(
          line.next(stamp, NAN, 1, out.empty(), static_cast<int>(out.size()) + 2, findings));
    return out;
  }
};
}  // namespace

TEST_CASE("time that runs keeps its bits and says nothing") {
  StampedClock clock;
  const std::vector<double> stamps{0.1, 0.2, 0.30000000000000004, 1e9, 1e9 + 0.1};
  CHECK(clock.run(stamps) == stamps);
  CHECK(clock.warnings.empty());
  CHECK_FALSE(clock.line.stands_still());
}

TEST_CASE("a repeated stamp is set a little later, the next true one counts again") {
  StampedClock clock;
  const auto time = clock.run({0, 1, 1, 2, 2, 3});
  CHECK(time[2] == Approx(1.001));
  CHECK(time[3] == 2);
  CHECK(time[5] == 3);
  REQUIRE(clock.warnings.size() == 1);
  CHECK(clock.warnings[0].line == 4);
}

TEST_CASE("a clock that was set back is shifted along, one wrong stamp is not") {
  StampedClock back;
  const auto time = back.run({100, 101, 41, 42, 43});
  CHECK(time[2] == Approx(101.001));
  CHECK(time[4] - time[3] == Approx(1));
  CHECK(back.warnings.size() == 1);
  StampedClock glitch;
  CHECK(glitch.run({10, 11, 0, 12, 13}).back() == 13);
}

TEST_CASE("any stamps whatever give a strictly increasing time") {
  std::mt19937 random(3);
  for (int test = 0; test < 200; ++test) {
    StampedClock clock;
    std::vector<double> stamps;
    for (int i = 0; i < 50; ++i)
      stamps.push_back(
          random() % 7 == 0 ? NAN : std::ldexp(random() % 9, static_cast<int>(random() % 40)));
    const auto time = clock.run(stamps);
    for (std::size_t i = 1; i < time.size(); ++i) REQUIRE(time[i] > time[i - 1]);
  }
}

TEST_CASE("stage times are strung together, placed by the test time where there is one") {
  std::vector<Warning> warnings;
  Findings findings(warnings);
  TimeLine only_stages(false, true);
  CHECK(only_stages.next(NAN, 0, 4, true, 2, findings) == 0);
  CHECK(only_stages.next(NAN, 120, 4, false, 3, findings) == 120);
  const double joined = only_stages.next(NAN, 0, 5, true, 4, findings);
  CHECK(joined == Approx(120.12));
  CHECK(only_stages.next(NAN, 300, 5, false, 5, findings) == joined + 300);
  CHECK(warnings.size() == 1);

  warnings.clear();
  Findings both(warnings);
  TimeLine placed(true, true);
  CHECK(placed.next(0, 0, 1, true, 2, both) == 0);
  CHECK(placed.next(305, 302, 1, false, 3, both) ==
        302);                                           // the stage's own clock is the better one
  CHECK(placed.next(500, 0, 2, true, 4, both) == 500);  // a pause is kept
  CHECK(warnings.empty());
  CHECK(placed.next(499, 0, 3, true, 5, both) > 500);
  CHECK(warnings.size() == 1);
}

TEST_CASE("a clock that never moves is known; no time at all is NaN") {
  StampedClock clock;
  clock.run({5, 5, 5});
  CHECK(clock.line.stands_still());
  TimeLine none(false, false);
  CHECK(std::isnan(none.next(NAN, NAN, 1, true, 2, clock.findings)));
  CHECK_FALSE(none.stands_still());
}
