// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps in raw channels; the equations themselves are tested in reduction_test.cpp.
#include "lab/reduction/raw_reduction.hpp"

#include <catch2/catch.hpp>

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
