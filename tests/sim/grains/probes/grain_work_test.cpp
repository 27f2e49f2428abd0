// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/probes/grain_work.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "sim/grains/engine/grains.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;
using Eigen::Vector3d;

namespace {

constexpr double kRadius = 1e-3;

/// side³ equal spheres in columns between the walls, in exact equilibrium: every contact of an
/// axis has the same overlap, and force E r × overlap.
GrainState columns(int side, const std::array<double, 3>& overlap) {
  std::vector<Sphere> spheres;
  GrainBox box;
  for (int a = 0; a < 3; ++a) box.high_m[a] = 2 * kRadius * side - (side + 1) * overlap[a];
  const auto at = [&](int a, int k) {
    return kRadius - overlap[a] + k * (2 * kRadius - overlap[a]);
  };
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) spheres.push_back({{at(0, x), at(1, y), at(2, z)}, kRadius});
  Grains grains(make_grain_state(spheres, box, test::undamped(), 1e-15));
  grains.step(1);
  return grains.state();
}

std::vector<Vector3d> unturned(const GrainState& s) {
  return std::vector<Vector3d>(s.grains.size(), Vector3d::Zero());
}

}  // namespace

TEST_CASE("Second-order work: columns of spheres give k Δδ² a contact, at walls and contacts") {
  const double d = 1e-5, change = 2e-8, k = 356e6 * kRadius;
  const int side = 3;
  const GrainState before = columns(side, {d, d, d}), after = columns(side, {d, d, d + change});
  const GrainWork w = grain_work(before, after, unturned(before));
  const double expected = side * side * (side + 1) * k * change * change / before.box.volume_m3();
  CHECK(w.lagrangian == Approx(expected).epsilon(1e-6));
  CHECK(w.microscopic() == Approx(expected).epsilon(1e-6));
  CHECK(w.microscopic() == Approx(w.lagrangian).epsilon(1e-7));
  CHECK(w.fixed_frame == Approx(w.lagrangian).epsilon(1e-7));
  CHECK(w.tangential_part == Approx(0).margin(1e-9 * expected));
  CHECK(w.non_permanent_part == 0);
  CHECK(w.contacts_before == 3 * side * side * (side + 1));
  CHECK(w.opened + w.closed == 0);
  CHECK(w.slides_after == 0);
}

TEST_CASE("Second-order work: Eulerian and Lagrangian values differ in the third order only") {
  const double d = 1e-5;
  const GrainState before = columns(3, {d, d, d});
  const auto difference = [&](double size) {
    const GrainState after = columns(3, {d - size, d + 0.5 * size, d + 2 * size});
    const GrainWork w = grain_work(before, after, unturned(before));
    CHECK(w.normalised > 0.9);
    return std::abs(w.eulerian() / w.lagrangian - 1);
  };
  CHECK(difference(1e-8) < 1e-4);
  CHECK(difference(4e-8) / difference(1e-8) == Approx(4).epsilon(0.1));
  const GrainState after = columns(3, {d, d, d + 1e-7});
  const GrainWork w = grain_work(before, after, unturned(before));
  CHECK(w.strain[2] == Approx(std::log(before.box.length_m(2) / after.box.length_m(2))));
  const double stress = 9 * 356e6 * kRadius * d / before.box.area_m2(2);
  CHECK(w.transport_part == Approx(stress * w.strain[2] * w.strain[2]).epsilon(1e-5));
  CHECK(w.volume_part == Approx(-w.transport_part).epsilon(1e-5));
}

TEST_CASE("Second-order work: contacts that open or close are counted apart") {
  const double d = 1e-6;
  const GrainState closed = columns(2, {d, d, d}), open = columns(2, {d, d, -d});
  const GrainWork opening = grain_work(closed, open, unturned(closed));
  CHECK(opening.opened == 12);
  CHECK(opening.closed == 0);
  CHECK(opening.non_permanent_share() == Approx(1.0 / 3));
  const double each = 356e6 * kRadius * d * 2 * d;
  CHECK(opening.fixed_frame == Approx(opening.microscopic()));
  CHECK(opening.non_permanent_part == Approx(12 * each / closed.box.volume_m3()).epsilon(1e-6));
  const GrainWork closing = grain_work(open, closed, unturned(closed));
  CHECK(closing.closed == 12);
  CHECK(closing.non_permanent_part == Approx(12 * each / open.box.volume_m3()).epsilon(1e-6));
}

TEST_CASE("Second-order work: states of two specimens are refused") {
  const GrainState a = columns(2, {1e-6, 1e-6, 1e-6}), b = columns(3, {1e-6, 1e-6, 1e-6});
  CHECK_THROWS_AS(grain_work(a, b, unturned(a)), std::invalid_argument);
  CHECK_THROWS_AS(grain_work(a, a, {}), std::invalid_argument);
}
