// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/consolidation_end.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "tests/lab/reduction/raw_record.hpp"

using namespace triax::lab;

namespace {

constexpr double kVolume_m3 = 5e-4;

/// One reading a second; volume (mm³) and excess pore pressure (kPa) over p' = 100 kPa by time.
ConsolidationEnd consolidated(int seconds, const std::function<double(double)>& volume_mm3,
                              const std::function<double(double)>& excess_kPa) {
  ConsolidationEnd end;
  for (int i = 0; i < seconds; ++i) {
    Reading r = triax::lab::testing::reading({2, 0, 0, 400, 300 + excess_kPa(i), volume_mm3(i)}, i);
    r[Quantity::back_pressure] = 300e3;
    State s;
    s.p_eff = 100e3;
    end.add(r, s, true, kVolume_m3);
  }
  return end;
}

const Check& of_kind(const std::vector<Check>& checks, CheckKind kind) {
  for (const Check& c : checks)
    if (c.kind == kind) return c;
  FAIL("no check " << to_string(kind));
  return checks.front();
}

}  // namespace

TEST_CASE("a steady outflow gives its rate, in percent of the volume per hour") {
  // 1 mm³/s is 3600 mm³/h of 500 000 mm³
  const auto end = consolidated(
      20000, [](double t) { return -t; }, [](double) { return 0.0; });
  const Check rate = of_kind(end.checks(), CheckKind::consolidation);
  CHECK(*rate.measured == Approx(0.72).epsilon(1e-9));
  CHECK_FALSE(rate.ok);
}

TEST_CASE("consolidation that has died out passes; cut short it does not") {
  const auto volume = [](double t) { return -5000 * (1 - std::exp(-t / 600)); };
  const auto excess = [](double t) { return 30 * std::exp(-t / 600); };
  for (const Check& check : consolidated(8000, volume, excess).checks()) {
    INFO(to_string(check.kind) << ' ' << *check.measured);
    CHECK(check.ok);
  }
  for (const Check& check : consolidated(900, volume, excess).checks()) CHECK_FALSE(check.ok);
}

TEST_CASE("ConsolidationEnd: few readings count only at the end of the stage") {
  // Readings at ever longer times, as by hand: 60 of them, e-fold every 4.
  const auto end = consolidated(
      60, [](double) { return -100.0; }, [](double t) { return 100 * std::exp(-t / 4); });
  CHECK(of_kind(end.checks(), CheckKind::zero_difference).ok);
}

TEST_CASE("at rest the difference of the two transducers is that of their zeros") {
  const auto end = consolidated(
      600, [](double) { return -100.0; }, [](double) { return -4.0; });
  CHECK(*end.difference() == Approx(-4e3));
  const Check zero = of_kind(end.checks(), CheckKind::zero_difference);
  CHECK(*zero.measured == Approx(0.04));
  CHECK_FALSE(zero.ok);
  CHECK(zero.note.find("4.00 kPa below the back pressure") != std::string::npos);
}

TEST_CASE("a new stage starts afresh; no stage and no time, no check") {
  ConsolidationEnd end;
  for (int i = 0; i < 400; ++i) {
    State s;
    s.p_eff = 100e3;
    const double volume = i < 200 ? -50.0 * i : -10000.0;
    end.add(triax::lab::testing::reading({i < 200 ? 1 : 2, 0, 0, 400, 300, volume}, i), s, true,
            kVolume_m3);
  }
  CHECK(*of_kind(end.checks(), CheckKind::consolidation).measured == Approx(0));
  CHECK(ConsolidationEnd().checks().empty());
  CHECK_FALSE(ConsolidationEnd().difference());
}
