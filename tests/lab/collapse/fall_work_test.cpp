// SPDX-License-Identifier: GPL-3.0-or-later
// Second-order work of a fall: closed forms of one finite increment.
#include "lab/collapse/fall_work.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::lab;

namespace {

State state(double reading, double q, double p, double axial, double volumetric) {
  State s;
  s.reading = static_cast<std::int64_t>(reading);
  s.q = q;
  s.p_eff = p;
  s.strain.axial = axial;
  s.volumetric_strain = volumetric;
  return s;
}

/// A path measured with that scatter of a reading (stress in Pa, strain).
PathPoint measured(double stress, double strain, std::int64_t window) {
  PathPoint p;
  const double share = 3 * static_cast<double>(window) / BlockPyramid::kBlocks;
  p.stress_variance = stress * stress / share;
  p.strain_variance = strain * strain / share;
  p.window_readings = window;
  return p;
}

}  // namespace

TEST_CASE("undrained, q lost against p' and shear: the cosine of the two increments") {
  const State before = state(10, 100e3, 150e3, 0.01, 0), after = state(11, 20e3, 40e3, 0.06, 0);
  const auto work = work_of_fall(before, after, measured(50, 1e-5, 7));
  REQUIRE(work);
  // dq dε_q over √(3 dp² + 2/3 dq²) √(3/2) dε_q
  const double dq = -80e3, dp = -110e3;
  CHECK(work->normalised ==
        Approx(dq / (std::sqrt(3 * dp * dp + dq * dq * 2 / 3) * std::sqrt(1.5))));
  CHECK(work->error ==
        Approx(std::hypot(
            std::sqrt(2.0) * 50 / std::hypot(std::sqrt(3.0) * dp, std::sqrt(2.0 / 3) * dq),
            std::sqrt(2.0) * 1e-5 / (std::sqrt(1.5) * 0.05))));
  CHECK(work->evidence.find("reading 10 to 11") != std::string::npos);
}

TEST_CASE("the noise of a reading is the same, however long the window that tells it") {
  const State before = state(10, 100e3, 150e3, 0.01, 0), after = state(11, 20e3, 40e3, 0.06, 0);
  CHECK(work_of_fall(before, after, measured(50, 1e-5, 7))->error ==
        Approx(work_of_fall(before, after, measured(50, 1e-5, 7 * 64))->error));
}

TEST_CASE("no proof: a load that grows with its strain, and a loss within the noise") {
  const State before = state(10, 100e3, 150e3, 0.01, 0);
  CHECK_FALSE(work_of_fall(before, state(11, 120e3, 170e3, 0.06, 0), measured(50, 1e-5, 7)));
  CHECK_FALSE(work_of_fall(before, state(11, 99.9e3, 150e3, 0.06, 0), measured(100, 1e-5, 7)));
}

TEST_CASE("a volume that nobody measured proves nothing") {
  const State before = state(10, 100e3, 150e3, 0.01, 0);
  CHECK_FALSE(
      work_of_fall(before, state(11, 20e3, 40e3, 0.06, std::nan("")), measured(50, 1e-5, 7)));
}
