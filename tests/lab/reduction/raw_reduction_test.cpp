// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps in raw channels; the equations themselves are tested in reduction_test.cpp.
#include "lab/reduction/raw_reduction.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "tests/lab/reduction/raw_record.hpp"

using namespace triax::lab;
using triax::lab::testing::raw_header;
using triax::lab::testing::reading;

TEST_CASE("u is read at the specimen; a gap there is not filled from the controller") {
  RawReduction reduction(raw_header(), {});
  Reading r = reading({3, 0, 0, 400, 310, 0});
  r[Quantity::back_pressure] = 300e3;
  CHECK(reduction.reduce(r).pore_pressure == 310e3);
  r[Quantity::pore_pressure] = kMissing;
  const State gap = reduction.reduce(r);
  CHECK(std::isnan(gap.pore_pressure));
  CHECK(std::isnan(gap.p_eff));
  CHECK(gap.q == Approx(0).margin(1e-9));
}

TEST_CASE("a record without a transducer at the specimen takes u at the controller") {
  RecordHeader header = raw_header();
  std::erase(header.columns, Quantity::pore_pressure);
  RawReduction reduction(header, {});
  Reading r = reading({3, 0, 0, 400, 300, 0});
  r[Quantity::pore_pressure] = kMissing;
  CHECK(reduction.reduce(r).pore_pressure == 300e3);
}

TEST_CASE("a gap at the first reading of shear does not move what strains count from") {
  RawReduction reduction(raw_header(), {});
  reduction.reduce(reading({2, 0.5, 0, 400, 300, -7000}));
  reduction.reduce(reading({2, 0.7, 0, 400, 300, -8000}, 1));
  Reading gap = reading({3, 0.7, 0, 400, 300, -8000}, 2);
  gap[Quantity::axial_displacement] = kMissing;
  gap[Quantity::back_volume] = kMissing;
  reduction.reduce(gap);
  const State s = reduction.reduce(reading({3, 0.7, 0, 400, 300, -8000}, 3));
  CHECK(s.strain.axial == 0);
  CHECK(s.volumetric_strain == 0);
}

TEST_CASE("a test of total stresses has q without a pore pressure, its membrane taken off") {
  RecordHeader header = raw_header();
  std::erase(header.columns, Quantity::pore_pressure);
  std::erase(header.columns, Quantity::back_pressure);
  CHECK_THROWS_AS(RawReduction(header, {}), BadInput);
  header.programme = "UU";
  header.specimen.membrane_modulus_pa = 1400e3;
  header.specimen.membrane_thickness_m = 0.3e-3;
  for (const auto membrane :
       {MembraneCorrection::none, MembraneCorrection::astm, MembraneCorrection::iso}) {
    RecordHeader full = header;
    full.columns.push_back(Quantity::pore_pressure);
    RawReduction with(full, {.membrane = membrane});
    RawReduction without(header, {.membrane = membrane});
    for (const double shortening : {0.0, 7.0, 14.0}) {
      const Reading known = reading({3, shortening, 0.5, 400, 300, 0});
      Reading unknown = known;
      unknown[Quantity::pore_pressure] = unknown[Quantity::back_pressure] = kMissing;
      const State expected = with.reduce(known), state = without.reduce(unknown);
      CHECK(state.q == Approx(expected.q));
      CHECK(std::isnan(state.p_eff));
      CHECK(std::isnan(state.effective_stress.axial));
    }
  }
}
