// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/size_bins.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "tests/sim/grains/packings.hpp"

using namespace triax;

TEST_CASE("bins of size hold every grain, and their radii stand for it within a bin's width") {
  const sim::GrainState state = sim::test::lattice(6);
  for (const int count : {1, 3, 12}) {
    const lab::SizeBins bins = lab::size_bins(state, count);
    REQUIRE(bins.of.size() == state.grains.size());
    CHECK(static_cast<int>(bins.radius_m.size()) <= count);
    CHECK(std::is_sorted(bins.radius_m.begin(), bins.radius_m.end()));
    const double width = std::pow(1.3, 1.0 / count);
    std::set<std::int32_t> used;
    for (std::size_t i = 0; i < bins.of.size(); ++i) {
      const double over = state.grains[i].radius / bins.radius_m[bins.of[i]];
      CHECK(over < width * 1.001);
      CHECK(over > 1 / width / 1.001);
      used.insert(bins.of[i]);
    }
    CHECK(used.size() == bins.radius_m.size());  // none is empty
    CHECK(bins.stiffness_error_most < width - 1 + 1e-3);
    CHECK(bins.stiffness_error_rms < bins.stiffness_error_most);
  }
}

TEST_CASE("more bins come nearer to the stiffness of each pair; equal grains need one") {
  const sim::GrainState state = sim::test::lattice(6);
  CHECK(lab::size_bins(state, 12).stiffness_error_rms <
        0.2 * lab::size_bins(state, 1).stiffness_error_rms);
  const auto equal = sim::test::pair_of(1e-3, 1e-3, 1e-5, sim::test::undamped());
  const lab::SizeBins one = lab::size_bins(equal, 12);
  CHECK(one.radius_m.size() == 1);
  CHECK(one.radius_m[0] == Approx(1e-3));
  CHECK(one.stiffness_error_most < 1e-12);
}
