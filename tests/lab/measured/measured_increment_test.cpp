// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/measured_increment.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "tests/lab/measured/synthetic_path.hpp"

using namespace triax::lab;
using triax::lab::testing::SyntheticPath;
using triax::lab::testing::undrained_header;

namespace {

const double kUnloading = std::numbers::pi + std::atan(1 / std::numbers::sqrt2);

std::optional<MeasuredIncrement> increment_at(SyntheticPath path, std::int64_t reading,
                                              int readings = 3000) {
  IncrementWatch watch(undrained_header(), reading);
  for (int i = 0; i < readings; ++i) watch.watch(path.state(i));
  return watch.finish();
}

/// Of the path in closed form.
double angle_at(const SyntheticPath& path, double strain) {
  const double h = 1e-7;
  const double dq = path.q(strain + h) - path.q(strain - h);
  const double dp = path.p(strain + h) - path.p(strain - h);
  const double angle = std::atan2(dp + 2 * dq / 3, std::numbers::sqrt2 * (dp - dq / 3));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

}  // namespace

TEST_CASE("the angle is that of the path's tangent, before, at and after the peak of q") {
  const SyntheticPath path;
  for (const std::int64_t reading : {100, 300, 450, 900, 1500}) {
    const auto own = increment_at(path, reading);
    REQUIRE(own);
    INFO(reading);
    const double strain = static_cast<double>(reading) * path.strain_step;
    CHECK(own->angle == Approx(angle_at(path, strain)).margin(2e-3));
    // Undrained, dq > 0 before the peak and < 0 behind it.
    CHECK((own->normalised > 0) == (strain < path.peak_strain));
    CHECK(own->rate.volumetric == Approx(0).margin(1e-15));
  }
}

TEST_CASE("at the peak of q an undrained test goes in the direction of isotropic unloading") {
  const auto own = increment_at({}, 600);
  REQUIRE(own);
  CHECK(own->angle == Approx(kUnloading).margin(5e-3));
  CHECK(own->normalised == Approx(0).margin(5e-3));
}

TEST_CASE("the stated error of the angle covers the true one, and grows with the noise") {
  SyntheticPath path;
  double largest = 0;
  for (const double noise : {20.0, 200.0}) {
    path.q_noise = path.u_noise = noise;
    int within = 0, all = 0;
    for (std::int64_t reading = 200; reading < 2500; reading += 100) {
      const auto own = increment_at(path, reading);
      REQUIRE(own);
      const double strain = static_cast<double>(reading) * path.strain_step;
      within += std::abs(own->angle - angle_at(path, strain)) < 3 * own->angle_error + 5e-3;
      ++all;
      if (reading == 1000) {
        CHECK(own->angle_error > largest);
        largest = own->angle_error;
      }
    }
    CHECK(within >= all - 2);
  }
}

TEST_CASE("no increment outside shear, beyond the record, or of stresses that stand still") {
  CHECK_FALSE(increment_at({}, 20000));
  CHECK_FALSE(increment_at({}, 3, 4));  // no window is full
  RecordHeader header = undrained_header();
  header.stages = {
      {.number = 1, .name = "consolidation", .role = StageRole::consolidation},
      {.number = 2, .name = "shear", .role = StageRole::shear, .drainage = Drainage::closed}};
  SyntheticPath path;
  for (const std::int64_t reading : {50, 150}) {
    IncrementWatch watch(header, reading);
    for (int i = 0; i < 400; ++i) {
      State s = path.state(i);
      s.stage = i < 100 ? 1 : 2;
      watch.watch(s);
    }
    CHECK(watch.finish().has_value() == (reading == 150));
  }
  IncrementWatch still(undrained_header(), 50);
  for (int i = 0; i < 100; ++i) {
    State s = path.state(i);
    s.q = 50e3;
    s.p_eff = 100e3;
    still.watch(s);
  }
  CHECK_FALSE(still.finish());
}

TEST_CASE("a stage that follows does not bend the last increment of the one before") {
  RecordHeader header = undrained_header();
  StageInfo second = header.stages[0];
  second.number = 2;
  header.stages.push_back(second);
  IncrementWatch watch(header, 399);
  SyntheticPath path;
  for (int i = 0; i < 800; ++i) {
    State s = path.state(i);
    if (i >= 400) {
      s.stage = 2;
      s.q = 2 * s.q;  // a jump
    }
    watch.watch(s);
  }
  const auto own = watch.finish();
  REQUIRE(own);
  CHECK(own->angle == Approx(angle_at(path, 399 * path.strain_step)).margin(0.02));
}

TEST_CASE("a direction that could be any is none: beyond 45 degrees of standard error") {
  constexpr double kDegree = std::numbers::pi / 180;
  MeasuredIncrement own;
  CHECK(own.has_direction());
  own.angle_error = 44 * kDegree;
  CHECK(own.has_direction());
  own.angle_error = 46 * kDegree;
  CHECK_FALSE(own.has_direction());
}
