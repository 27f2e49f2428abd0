#include "lab/devices/transducer.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax;
using lab::Transducer;

namespace {
Transducer in_kPa() {
  Transducer t;
  t.unit = *sim::find_unit("kPa");
  return t;
}
}  // namespace

TEST_CASE("without imperfections the true value passes through") {
  for (const double si : {0.0, 123456.789, -1e-3, 5e5 / 3, 400123.0625})
    CHECK(lab::read(in_kPa(), si, 1.7).si == Approx(si).epsilon(3e-16).margin(0));
}

TEST_CASE("readings are multiples of the step that a file can hold bit for bit") {
  Transducer t = in_kPa();
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
  Transducer t = in_kPa();
  t.noise_rms = 0.05;
  t.offset = 2;
  CHECK(lab::read(t, 100e3, 3).si == Approx(102.15e3));
}

TEST_CASE("a transducer stops at its range and says so") {
  Transducer t = in_kPa();
  t.range = 500;
  CHECK(lab::read(t, 600e3, 0).si == 500e3);
  CHECK(lab::read(t, 600e3, 0).saturated);
  CHECK(lab::read(t, -600e3, 0).si == -500e3);
  CHECK_FALSE(lab::read(t, 500e3, 0).saturated);
}

TEST_CASE("zero is never negative") {
  Transducer t = in_kPa();
  t.step = 1;
  CHECK_FALSE(std::signbit(lab::read(t, -100, 0).si));
}
