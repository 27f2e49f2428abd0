// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/probes/boundary_term.hpp"

#include <catch2/catch.hpp>

using namespace triax::sim;

namespace {

GrainBox box_after(const GrainBox& start, double low, double high) {
  GrainBox box = start;
  box.low_m[1] += low;
  box.high_m[1] += high;
  return box;
}

}  // namespace

TEST_CASE("Boundary term: walls that move steadily give none, others the force times u'' T^2") {
  GrainState start;
  start.box = {{0, 0, 0}, {0.1, 0.2, 0.3}};
  start.walls.force_n = {1, 2, 30, 50, 5, 6};
  const double volume = 0.1 * 0.2 * 0.3, v = 1e-6, a = 3e-7;
  for (const double share : {0.5, 0.3}) {
    const auto way = [&](double t, double speed, double growth) {
      return speed * t + 0.5 * growth * t * t;
    };
    CHECK(boundary_term(start, box_after(start.box, share * v, -share * v), share,
                        box_after(start.box, v, -v)) == Approx(0).margin(1e-12));
    // The low wall grows faster by a, the high one slower by 2 a: 30 N inwards, 50 N inwards.
    const double term =
        boundary_term(start, box_after(start.box, way(share, v, a), way(share, -v, 2 * a)), share,
                      box_after(start.box, way(1, v, a), way(1, -v, 2 * a)));
    CHECK(term == Approx((30 * a - 50 * 2 * a) / volume).epsilon(1e-6));
  }
}
