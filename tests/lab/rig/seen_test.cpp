// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/seen.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/rig_header.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;

namespace {

RecordHeader header() { return rig_header(read_programme(test::programme_text(), "p.toml"), 1); }

Reading at(double time_s, double displacement_m, double force_n) {
  Reading r;
  r.time_s = time_s;
  r.si.fill(0);
  for (std::size_t i = kRawQuantityCount; i < kQuantityCount; ++i) r.si[i] = kMissing;
  r[Quantity::axial_displacement] = displacement_m;
  r[Quantity::axial_force] = force_n;
  r[Quantity::cell_pressure] = 400e3 + 1e3 * time_s;
  r[Quantity::back_pressure] = 300e3;
  r[Quantity::pore_pressure] = 300e3 + 980 * time_s;
  r[Quantity::back_volume] = -1e-9 * time_s;
  return r;
}

}  // namespace

TEST_CASE("what is seen is reduced as in a report") {
  Seen seen(header());
  seen.take(at(0, 0, 0));
  seen.begin_stage();
  seen.take(at(1, 1.4e-3, 10));
  CHECK(seen.value(EndQuantity::axial_strain) == Approx(0.01));
  const double area = M_PI / 4 * 0.07 * 0.07 / 0.99;
  CHECK(seen.value(EndQuantity::deviator_stress) == Approx(10 / area).epsilon(1e-5));
  CHECK(seen.value(EndQuantity::pore_pressure_lag) == Approx(980));
  CHECK(std::isnan(seen.value(EndQuantity::b_value)));
  for (int i = 2; i <= 10; ++i) seen.take(at(i, 1.4e-3, 10));
  CHECK(seen.value(EndQuantity::b_value) == Approx(0.98));
}

TEST_CASE("the area is expected to go on as between the last two looks") {
  Seen seen(header());
  seen.take(at(0, 0, 0));
  seen.begin_stage();
  seen.take(at(1, 1.4e-4, 0));
  const double area = M_PI / 4 * 0.07 * 0.07 / 0.999;
  CHECK(seen.next_area_m2() == Approx(2 * area - area * 0.999).epsilon(1e-5));
}

TEST_CASE("rates run over half a minute") {
  Seen seen(header());
  seen.take(at(0, 0, 0));
  seen.begin_stage();
  for (int i = 1; i < 29; ++i) seen.take(at(i, i * 1e-6, 0));
  CHECK(std::isnan(seen.value(EndQuantity::axial_rate)));
  for (int i = 29; i < 70; ++i) seen.take(at(i, i * 1e-6, 0));
  CHECK(seen.value(EndQuantity::axial_rate) == Approx(1e-6));
  CHECK(seen.value(EndQuantity::volume_rate) == Approx(1e-9));
}

TEST_CASE("a spike ends no stage, a gap keeps the last value") {
  Seen seen(header());
  const EndCondition end{EndQuantity::axial_force, 50.0, {}};
  seen.take(at(0, 0, 0));
  seen.begin_stage();
  seen.take(at(1, 0, 100));
  CHECK_FALSE(seen.met(end));
  seen.take(at(2, 0, 0));
  CHECK_FALSE(seen.met(end));
  seen.take(at(3, 0, 60));
  seen.take(at(4, 0, kMissing));
  CHECK(seen[Quantity::axial_force] == 60);
  CHECK(seen.met(end));
}

TEST_CASE("an area that leaps and comes back moves no control loop; one that stays does") {
  Seen seen(header());
  seen.take(at(0, 0, 0));
  seen.begin_stage();
  seen.take(at(1, 1e-5, 0));
  const double area = seen.steady_area_m2();
  CHECK(area == Approx(seen.state().area_m2));
  seen.take(at(2, 1e-3, 0));
  CHECK(seen.state().area_m2 > 1.005 * area);
  CHECK(seen.steady_area_m2() == area);
  CHECK(seen.next_area_m2() == area);
  seen.take(at(3, 1e-5, 0));
  CHECK(seen.steady_area_m2() == Approx(area).epsilon(1e-4));
  seen.take(at(4, 1e-3, 0));
  seen.take(at(5, 1e-3, 0));
  CHECK(seen.steady_area_m2() == seen.state().area_m2);
}

TEST_CASE("time of a stage is what ran of it") {
  Seen seen(header());
  seen.take(at(0, 0, 0));
  seen.begin_stage();
  const EndCondition end{EndQuantity::time, 2.0, {}};
  seen.add_stage_time(1);
  CHECK_FALSE(seen.met(end));
  seen.add_stage_time(1);
  CHECK(seen.met(end));
}
