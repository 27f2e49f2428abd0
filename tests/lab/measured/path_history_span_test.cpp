// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/path_history.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

/// q goes 100, 110, 120 ... a reading; p' is noise-free at 200.
PathHistory history(int readings) {
  PathHistory h;
  for (int i = 0; i < readings; ++i) {
    PathSample s;
    s.signal = {static_cast<double>(i), i * 1.0, 100.0 + 10 * i, 200, 0.001 * i, 0, 50};
    h.add(s);
  }
  return h;
}

PathPoint at(double reading, double q, std::int64_t window) {
  PathPoint p;
  p.reading = reading;
  p.q = q;
  p.p_eff = 210;
  p.axial_strain = 0.001 * reading;
  p.pore_pressure = 50;
  p.window_readings = window;
  return p;
}

}  // namespace

TEST_CASE("a fitted value lies within what was measured beside it") {
  const PathHistory h = history(40);
  const PathPoint high = within_measured(at(20.4, 500, BlockPyramid::kBlocks), h);
  CHECK(high.q == 310);  // readings 20 and 21 hold 300 and 310
  CHECK(high.p_eff == 200);
  CHECK(high.axial_strain == Approx(0.0204));  // within, and left as it is
  CHECK(within_measured(at(20.4, -5, BlockPyramid::kBlocks), h).q == 300);
  CHECK(within_measured(at(20.4, 500, 56), h).q == 330);  // three on each side
}

TEST_CASE("an onset at a reading has its two neighbours") {
  CHECK(within_measured(at(20, 500, BlockPyramid::kBlocks), history(40)).q == 310);
}

TEST_CASE("what is known in blocks only bounds nothing") {
  CHECK(within_measured(at(20.4, 500, 56), history(5000)).q == 500);
  CHECK(within_measured(at(20.4, 500, 56), PathHistory()).q == 500);
}
