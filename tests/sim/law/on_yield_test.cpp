// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/law/on_yield.hpp"

#include <catch2/catch.hpp>

using namespace triax::sim;

namespace {

/// Three mechanisms at given distances from yield.
class Distant : public Law<Axisymmetric> {
 public:
  void response(const State&, Response<Axisymmetric>&) const override {}
  double yield_distance(const State& state, int mechanism) const override {
    return state.memory(mechanism);
  }
};

unsigned standing(double a, double b, double c, int mechanisms = 3) {
  PointState<Axisymmetric> state;
  state.memory = Eigen::Vector3d(a, b, c);
  return mechanisms_on_yield<Axisymmetric>(Distant(), state, mechanisms);
}

}  // namespace

TEST_CASE("a state stands on the surfaces that it is within round-off of, or beyond") {
  CHECK(standing(-0.1, -0.1, -0.1) == 0b000);
  CHECK(standing(0, -0.1, 1e-3) == 0b101);
  CHECK(standing(-0.5 * kOnYield, -2 * kOnYield, -0.1) == 0b001);
  CHECK(standing(0, 0, 0) == 0b111);
  CHECK(standing(0, 0, 0, 2) == 0b011);
  CHECK(standing(0, 0, 0, 0) == 0b000);
}
