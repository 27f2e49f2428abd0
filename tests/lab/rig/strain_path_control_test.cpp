// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/strain_path_control.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/rig/rig_header.hpp"
#include "tests/lab/rig/rig_text.hpp"

using namespace triax::lab;

namespace {

constexpr double kHeightAtStart = 0.14, kVolumeAtStart = 0.07 * 0.07 * M_PI / 4 * kHeightAtStart;

Seen seen_at(double displacement_m, double back_volume_m3) {
  static const RecordHeader header = rig_header(
      test::rig_programme(test::shear_stage("open", "displacement", "axial_rate_mm_per_min = 1.0",
                                            R"("q_kPa", above = 1.0)")),
      1);
  Seen seen(header);
  Reading r;
  r.time_s = 0;
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) r.si[i] = 0;
  r[Quantity::cell_pressure] = 400e3;
  r[Quantity::pore_pressure] = 300e3;
  seen.take(r);
  r.time_s = 1;
  r[Quantity::axial_displacement] = displacement_m;
  r[Quantity::back_volume] = back_volume_m3;
  seen.take(r);
  seen.begin_stage();
  return seen;
}

StrainPathControl path_control_started(std::optional<double> R, const Seen& seen,
                                       double filter_s = 0) {
  Stage stage;
  stage.axial = AxialAction::displacement;
  stage.axial_rate_m_per_s = 1e-5;
  stage.strain_path_R = R;
  StrainPathControl control(kHeightAtStart, filter_s);
  control.begin_stage(stage, seen);
  return control;
}

}  // namespace

TEST_CASE("a stage without a strain path leaves the volume to the pressure controller") {
  const Seen seen = seen_at(0, 0);
  CHECK_FALSE(path_control_started({}, seen).outflow_m3_per_s(seen, 0.25));
}

TEST_CASE("R = 1 keeps the volume, more lets water out, less takes it in") {
  const Seen seen = seen_at(0, 0);
  CHECK(*path_control_started(1.0, seen).outflow_m3_per_s(seen, 0.25) == Approx(0).margin(1e-18));
  CHECK(*path_control_started(1.3, seen).outflow_m3_per_s(seen, 0.25) > 0);
  CHECK(*path_control_started(0.7, seen).outflow_m3_per_s(seen, 0.25) < 0);
}

TEST_CASE("followed tick by tick, the strains are in proportion to the last bit that counts") {
  const double R = GENERATE(0.7, 1.3);
  StrainPathControl control = path_control_started(R, seen_at(0, 0));
  constexpr double kTick = 0.25;
  double displacement = 0, back_volume = 0;
  for (int i = 0; i < 400; ++i) {
    back_volume -= *control.outflow_m3_per_s(seen_at(displacement, back_volume), kTick) * kTick;
    displacement += 1e-5 * kTick;
  }
  const double axial = -std::log1p(-displacement / kHeightAtStart);
  const double radial = 0.5 * (-std::log1p(back_volume / kVolumeAtStart) - axial);
  CHECK(axial > 0.007);
  CHECK(axial + 2 * R * radial == Approx(0).margin(1e-12));
}

TEST_CASE("what was missed before is made good within the tick") {
  StrainPathControl control = path_control_started(1.0, seen_at(0, 0));
  CHECK(*control.outflow_m3_per_s(seen_at(0, 2e-9), 0.5) == Approx(4e-9));
}

TEST_CASE("strains count from the start of the stage, not of the test") {
  const Seen then = seen_at(5e-3, -3e-6);
  auto control = path_control_started(1.3, then);
  // dV = (1 − 1/R) dH V/H, V and H of the start of the stage.
  const double volume = kVolumeAtStart - 3e-6, height = kHeightAtStart - 5e-3;
  CHECK(*control.outflow_m3_per_s(then, 0.25) ==
        Approx((1 - 1 / 1.3) * 1e-5 * volume / height).epsilon(1e-4));
}

TEST_CASE("a servo that smooths keeps the path, and the noise of the height out of the flow") {
  constexpr double kTick = 0.25, kNoise = 1e-6;
  StrainPathControl control = path_control_started(0.7, seen_at(0, 0), 10);
  double displacement = 0, back_volume = 0, least = 0, most = -1;
  for (int i = 0; i < 4000; ++i) {
    const double read = displacement + kNoise * std::sin(17.0 * i * i);
    const double flow = *control.outflow_m3_per_s(seen_at(read, back_volume), kTick);
    back_volume -= flow * kTick;
    displacement += 1e-5 * kTick;
    if (i < 400) continue;
    least = std::min(least, flow);
    most = std::max(most, flow);
  }
  const double axial = -std::log1p(-displacement / kHeightAtStart);
  const double radial = 0.5 * (-std::log1p(back_volume / kVolumeAtStart) - axial);
  CHECK(axial + 1.4 * radial == Approx(0).margin(2e-5));
  // Unsmoothed the flow would swing by twice 1 - 1/R times 1 µm of height in every tick.
  const double unsmoothed = 2 * (1 / 0.7 - 1) * kNoise * kVolumeAtStart / kHeightAtStart / kTick;
  CHECK(most < 0);
  CHECK(most - least < unsmoothed / 5);
}
