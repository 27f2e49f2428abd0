// SPDX-License-Identifier: GPL-3.0-or-later
// When a reading is recorded, and what of the looks before it is in it.
#include "lab/rig/logger.hpp"

#include <catch2/catch.hpp>

using namespace triax;
using namespace triax::lab;

namespace {

std::array<Transducer, kRawQuantityCount> transducers() {
  std::array<Transducer, kRawQuantityCount> all;
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) all[i].unit = *sim::find_unit("kPa");
  return all;
}

Reading look(double time_s, double pressure_pa) {
  Reading r;
  r.time_s = time_s;
  r[Quantity::pore_pressure] = pressure_pa;
  return r;
}

}  // namespace

TEST_CASE("readings follow each other at the interval from where the stage began") {
  Logger logger(transducers());
  logger.begin({.interval_s = 2.5, .averaging_s = 0}, 10);
  CHECK(logger.due_s() == 12.5);
  logger.record(look(12.5, 1));
  CHECK(logger.due_s() == 15);
  logger.begin({.interval_s = 30, .averaging_s = 0}, 15);
  CHECK(logger.due_s() == 45);
}

TEST_CASE("without averaging a reading is the look at its instant, to the bit") {
  Logger logger(transducers());
  logger.begin({.interval_s = 1, .averaging_s = 0}, 0);
  for (const double t : {0.25, 0.5, 0.75}) logger.add(look(t, 7e3));
  const double odd = 1e3 / 3;
  CHECK(logger.record(look(1, odd))[Quantity::pore_pressure] == odd);
}

TEST_CASE("a mean reaches back over the window only, and not into the reading before") {
  Logger logger(transducers());
  logger.begin({.interval_s = 2, .averaging_s = 1}, 0);
  for (const double t : {0.25, 0.5, 0.75, 1.0}) logger.add(look(t, 900e3));
  logger.add(look(1.5, 100e3));
  CHECK(logger.record(look(2, 103e3))[Quantity::pore_pressure] == Approx(101.5e3));
  CHECK(logger.record(look(4, 50e3))[Quantity::pore_pressure] == Approx(50e3));
}

TEST_CASE("a spike in a quarter of the looks does not show") {
  Logger logger(transducers());
  logger.begin({.interval_s = 2, .averaging_s = 2}, 0);
  for (const double value : {100e3, 500e3, 101e3, 102e3, 500e3, 101e3, 100e3})
    logger.add(look(1, value));
  const double mean = logger.record(look(2, 102e3))[Quantity::pore_pressure];
  CHECK(mean > 100e3);
  CHECK(mean < 102.1e3);
}

TEST_CASE("looks that a channel misses do not count; a channel that says nothing stays empty") {
  Logger logger(transducers());
  logger.begin({.interval_s = 2, .averaging_s = 2}, 0);
  logger.add(look(1, 100e3));
  logger.add(look(1.25, kMissing));
  logger.add(look(1.5, 102e3));
  const Reading reading = logger.record(look(2, kMissing));
  CHECK(reading[Quantity::pore_pressure] == Approx(101e3));
  CHECK_FALSE(reading.has(Quantity::axial_force));
}

TEST_CASE("noise that moves a coarse converter by a step now and then is in the mean") {
  auto coarse = transducers();
  coarse[index(Quantity::pore_pressure)].step = 1;  // kPa
  Logger logger(coarse);
  logger.begin({.interval_s = 2, .averaging_s = 2}, 0);
  for (const double value : {100e3, 100e3, 101e3, 100e3, 100e3, 100e3, 99e3, 101e3, 140e3})
    logger.add(look(1, value));
  CHECK(logger.record(look(2, 100e3))[Quantity::pore_pressure] == Approx(901e3 / 9));
}
