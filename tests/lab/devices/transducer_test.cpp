// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/transducer.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "lab/devices/noise.hpp"

using namespace triax;
using lab::Transducer;

namespace {
Transducer perfect_in_kPa() {
  Transducer t;
  t.unit = *sim::find_unit("kPa");
  return t;
}
}  // namespace

TEST_CASE("without imperfections the true value passes through") {
  for (const double si : {0.0, 123456.789, -1e-3, 5e5 / 3, 400123.0625})
    CHECK(lab::read(perfect_in_kPa(), si, 1.7).si == Approx(si).epsilon(3e-16).margin(0));
}

TEST_CASE("readings are multiples of the step that a file can hold bit for bit") {
  Transducer t = perfect_in_kPa();
  t.range = 1000;
  t.step = lab::converter_step(1000, 16);
  CHECK(t.step == 2000.0 / 65536);
  const double si = lab::read(t, 123456.789, 0).si;
  CHECK(std::abs(si - 123456.789) <= 1e3 * t.step / 2);
  const double field = sim::to_field(si, t.unit);
  CHECK(sim::to_si(field, t.unit) == si);
  CHECK(std::remainder(field, t.step) == Approx(0).margin(1e-9));
}

TEST_CASE("noise and offset are in the unit of the field") {
  Transducer t = perfect_in_kPa();
  t.noise_rms = 0.05;
  t.offset = 2;
  CHECK(lab::read(t, 100e3, 3).si == Approx(102.15e3));
}

TEST_CASE("a transducer stops at its range and says so") {
  Transducer t = perfect_in_kPa();
  t.range = 500;
  CHECK(lab::read(t, 600e3, 0).si == 500e3);
  CHECK(lab::read(t, 600e3, 0).saturated);
  CHECK(lab::read(t, -600e3, 0).si == -500e3);
  CHECK_FALSE(lab::read(t, 500e3, 0).saturated);
}

TEST_CASE("zero is never negative") {
  Transducer t = perfect_in_kPa();
  t.step = 1;
  CHECK_FALSE(std::signbit(lab::read(t, -100, 0).si));
}

namespace {
/// Looks with seed 7, stream 2.
lab::TransducerReading seen(const Transducer& t, lab::TransducerState& state, double field,
                            double time_s) {
  return lab::look(t, state, sim::to_si(field, t.unit), time_s, 7, 2);
}
double seen_kPa(const Transducer& t, lab::TransducerState& state, double field, double time_s) {
  return sim::to_field(seen(t, state, field, time_s).si, t.unit);
}
}  // namespace

TEST_CASE("a look without imperfections gives the true value to the bit") {
  lab::TransducerState state;
  double time_s = 0;
  for (const double field : {0.0, 123.456789, -1e-6, 500.0 / 3, 400.123, 0.1}) {
    const double si = sim::to_si(field, perfect_in_kPa().unit);
    const auto reading = lab::look(perfect_in_kPa(), state, si, time_s += 0.25, 7, 2);
    CHECK(reading.si == si);
    CHECK_FALSE(reading.saturated);
  }
}

TEST_CASE("the noise of a look is that of its number, seed and channel") {
  Transducer t = perfect_in_kPa();
  t.noise_rms = 0.5;
  lab::TransducerState state, again;
  for (int i = 0; i < 5; ++i) {
    const double si =
        lab::read(t, 100e3, lab::standard_normal(7, 2, static_cast<std::uint64_t>(i))).si;
    CHECK(seen(t, state, 100, i).si == si);
    CHECK(lab::look(t, again, 100e3, i, 7, 3).si != si);
  }
}

TEST_CASE("a slow transducer answers a ramp with the lag of its time constant") {
  Transducer t = perfect_in_kPa();
  t.time_constant_s = 2;
  lab::TransducerState state;
  CHECK(seen_kPa(t, state, 50, 0) == 50);
  CHECK(seen_kPa(t, state, 60, 1) == Approx(60 - 20 * (1 - std::exp(-0.5))));
  for (int i = 2; i <= 60; ++i) seen(t, state, 50 + 10 * i, i);
  CHECK(seen_kPa(t, state, 50 + 610, 61) == Approx(660 - 20).epsilon(1e-12));
}

TEST_CASE("rising and falling readings are two half widths of the hysteresis apart") {
  Transducer t = perfect_in_kPa();
  t.range = 160;
  t.hysteresis = 1.6;
  lab::TransducerState state;
  double time = 0;
  const auto at = [&](double field) { return seen_kPa(t, state, field, time++); };
  at(0), at(160), at(0);
  const double rising = at(80);
  at(160);
  CHECK(at(80) - rising == Approx(2 * 1.6));
}

TEST_CASE("non-linearity is 0 at both ends, greatest in the middle and of the reading's sign") {
  Transducer t = perfect_in_kPa();
  t.range = 1000;
  t.nonlinearity = 2;
  const auto reading = [&](double field) {
    lab::TransducerState state;
    return seen_kPa(t, state, field, 0);
  };
  CHECK(reading(0) == 0);
  CHECK(reading(1000) == 1000);
  CHECK(reading(500) == Approx(502));
  CHECK(reading(-500) == Approx(-502));
  CHECK(reading(250) == Approx(251.5));
  for (double field = 0; field <= 1000; field += 7) CHECK(reading(field) - field <= 2 + 1e-9);
}

TEST_CASE("the zero drifts with test time") {
  Transducer t = perfect_in_kPa();
  t.drift_per_hour = 0.4;
  lab::TransducerState state;
  CHECK(seen_kPa(t, state, 100, 0) == 100);
  CHECK(seen_kPa(t, state, 100, 1800) == Approx(100.2));
  CHECK(seen_kPa(t, state, 100, 36000) == Approx(104));
}

TEST_CASE("a calibration polynomial turns millivolts into the unit and can undo a non-linearity") {
  Transducer t = perfect_in_kPa();
  t.range = 1000;
  t.sensitivity_mV = 100;
  const auto reading = [&](double field) {
    lab::TransducerState state;
    return seen_kPa(t, state, field, 0);
  };
  CHECK(reading(345.6) == 345.6);
  t.calibration = {0, 10};
  CHECK(reading(345.6) == Approx(345.6).epsilon(1e-15));
  t.calibration = {3, 10.2};
  CHECK(reading(345.6) == Approx(3 + 34.56 * 10.2));
  // x + 4 n r (1 - r) of a signal: taken back to first order in n by 1 - 4 n/range ...
  t.nonlinearity = 1;
  t.calibration = {0, 10 * (1 - 0.004), 4 * 1 * 1e-4};
  for (const double field : {100.0, 500.0, 900.0})
    CHECK(std::abs(reading(field) - field) < 0.005 * 1);
}

TEST_CASE("a converter acts on the electrical signal in front of the polynomial") {
  Transducer t = perfect_in_kPa();
  t.range = 1000;
  t.sensitivity_mV = 100;
  t.step = 2;               // 0.2 mV
  t.calibration = {0, 11};  // a wrong one
  lab::TransducerState state;
  CHECK(seen_kPa(t, state, 501.1, 0) == Approx(50.2 * 11));
  const auto beyond = seen(t, state, 2000, 1);
  CHECK(beyond.saturated);
  CHECK(beyond.si == Approx(1100e3));
  CHECK(lab::end_of_range_si(t) == beyond.si);
  CHECK(lab::end_of_range_si(t, -1) == Approx(-1100e3));
  CHECK(std::isinf(lab::end_of_range_si(perfect_in_kPa())));
}

TEST_CASE("samples are held, and depend on how often one looks neither in value nor in noise") {
  Transducer t = perfect_in_kPa();
  t.sampling_interval_s = 2;
  t.noise_rms = 0.5;
  t.time_constant_s = 3;
  // A ramp of 4 kPa/s, seen every 0.1 s, every 0.5 s and every 3 s.
  const auto course = [&](double interval_s) {
    lab::TransducerState state;
    std::vector<double> at_whole_6_s;
    const auto every = static_cast<int>(std::lround(6 / interval_s));
    for (int i = 0; i <= 10 * every; ++i) {
      const double time_s = i * interval_s;
      const double si = seen(t, state, 4 * time_s, time_s).si;
      if (i % every == 0) at_whole_6_s.push_back(si);
    }
    return at_whole_6_s;
  };
  const auto fine = course(0.1), coarse = course(3);
  REQUIRE(fine.size() == 11);
  for (std::size_t i = 0; i < fine.size(); ++i) {
    CHECK(fine[i] == Approx(coarse[i]).epsilon(1e-10));
    CHECK(course(0.5)[i] == Approx(coarse[i]).epsilon(1e-10));
  }
  lab::TransducerState state;
  t.noise_rms = t.time_constant_s = 0;
  CHECK(seen_kPa(t, state, 0, 0) == 0);
  CHECK(seen_kPa(t, state, 4, 1) == 0);
  CHECK(seen_kPa(t, state, 12, 3) == Approx(8));
  CHECK(seen_kPa(t, state, 14, 3.5) == Approx(8));
  CHECK(seen_kPa(t, state, 16, 4) == 16);
}

TEST_CASE("a copied state goes on like its original") {
  Transducer t = perfect_in_kPa();
  t.noise_rms = 0.5;
  t.range = 100;
  t.hysteresis = 0.2;
  t.time_constant_s = 1;
  lab::TransducerState state;
  for (int i = 0; i < 7; ++i) seen(t, state, 3 * i, i);
  lab::TransducerState copy = state;
  CHECK(copy == state);
  CHECK(seen(t, state, 5, 8).si == seen(t, copy, 5, 8).si);
  CHECK(copy == state);
}
