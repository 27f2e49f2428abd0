// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/scans/scan_codec.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <random>

#include "tests/db/scans.hpp"

using namespace triax;
using triax::lab::Quantity;

namespace {

/// Through encode, a table's notion of numbers (it does not know −0), and back.
void check_round_trip(const lab::Reading& reading, const lab::State& state,
                      const db::StageReference& reference, bool expect_detail) {
  db::ScanRow row;
  db::ScanDetail detail;
  const bool needs_detail = db::encode(reading, state, reference, row, detail);
  CHECK(needs_detail == expect_detail);
  for (double* value : {&row.time_s, &row.axial_strain, &row.volumetric_strain, &row.q_pa,
                        &row.p_eff_pa, row.raw.data() + 5})
    if (*value == 0) *value = 0.0;
  lab::Reading reading_back;
  lab::State state_back;
  db::decode(row, needs_detail ? &detail : nullptr, reference, reading_back, state_back);
  CHECK(testing::same(reading, reading_back));
  CHECK(testing::same(state, state_back));
}

}  // namespace

TEST_CASE("scans reduced by the laboratory's formulas come back to the bit without a detail") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto [reading, state] = testing::raw_scan(random, i);
    check_round_trip(reading, state, {testing::kVoidRatio, testing::kArea}, false);
  }
}

TEST_CASE("a decimal of the field is stored as that decimal, not as its neighbour") {
  lab::State state;
  for (int i = 0; i < 100000; ++i) {
    const double pressure_kPa = i / 100.0, volume_mm3 = i / 10.0, force_kN = i / 1e6;
    lab::Reading reading;
    reading[Quantity::cell_pressure] = pressure_kPa * 1e3;
    reading[Quantity::back_volume] = volume_mm3 * 1e-9;
    reading[Quantity::axial_force] = force_kN * 1e3;
    db::ScanRow row;
    db::ScanDetail detail;
    db::encode(reading, state, {}, row, detail);
    REQUIRE(row.raw[lab::index(Quantity::cell_pressure)] == pressure_kPa);
    REQUIRE(row.raw[lab::index(Quantity::back_volume)] == volume_mm3);
    REQUIRE(row.raw[lab::index(Quantity::axial_force)] == force_kN);
    REQUIRE(row.last_bits == 0);
  }
}

TEST_CASE("SI values that no number in units of the field leads to come back to the bit") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> exponent(-9, 9), sign(-1, 1);
  int with_last_bits = 0;
  for (int i = 0; i < 20000; ++i) {
    lab::Reading reading;
    reading.number = i;
    for (std::size_t q = 0; q < lab::kQuantityCount; ++q)
      reading.si[q] = std::copysign(std::pow(10, exponent(random)), sign(random));
    lab::State state;
    state.reading = i;
    db::ScanRow row;
    db::ScanDetail detail;
    db::encode(reading, state, {}, row, detail);
    with_last_bits += (row.last_bits & 0x1fffff) != 0;
    // The state is unknown although the channels would give stresses: a detail has to say so.
    check_round_trip(reading, state, {}, true);
  }
  CHECK(with_last_bits > 0);  // else this proves nothing
}

TEST_CASE("states that follow from nothing come back to the bit") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20000; ++i) {
    lab::Reading reading = testing::raw_scan(random, i).first;
    check_round_trip(reading, testing::wild_state(random, reading), {0.8, 0.004}, true);
  }
}

TEST_CASE("both zeros and missing values come back as they were") {
  lab::Reading reading;
  reading.number = 5;
  reading.time_s = -0.0;
  reading[Quantity::back_volume] = -0.0;
  lab::State state;
  state.reading = 5;
  state.time_s = -0.0;
  state.strain = {-0.0, 0.0};
  state.volumetric_strain = -0.0;
  state.q = -0.0;
  state.p_eff = 0.0;
  check_round_trip(reading, state, {}, false);
}

TEST_CASE("a stress state without channels follows from p' and q") {
  lab::Reading reading;
  lab::State state;
  state.strain.axial = 0.01;
  state.volumetric_strain = 0.002;
  state.strain.radial = (0.002 - 0.01) / 2;
  state.q = 56.5e3;
  state.p_eff = 80.1e3;
  state.effective_stress = {80.1e3 + 2 * 56.5e3 / 3, 80.1e3 - 56.5e3 / 3};
  check_round_trip(reading, state, {}, false);
  state.effective_stress.axial = std::nextafter(state.effective_stress.axial, 0);
  check_round_trip(reading, state, {}, false);
}

TEST_CASE("the reference of a stage is what its states follow from") {
  lab::State state;
  state.volumetric_strain = 0.02;
  state.strain.axial = 0.05;
  state.void_ratio = 0.9 - 0.02 * 1.9;
  state.area_m2 = 0.004 * (1 - 0.02) / (1 - 0.05);
  const db::StageReference reference = db::reference_of(state);
  CHECK(reference.void_ratio == Approx(0.9).epsilon(1e-14));
  CHECK(reference.area_m2 == Approx(0.004).epsilon(1e-14));
}
