// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/plane_rate.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/stability/stability_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

TEST_CASE("a stress rate of the plane says what the prober does") {
  const auto material = inl2();
  const auto state = state_at(material, 70, 0.5, 1.086);
  const auto prober = stress_prober<Axisymmetric>(material, state);
  const IncrementalResponse<Axisymmetric> response(material, state);

  const auto tensor = law<Tensor>(Interpolation::inl2, kInl2);
  const auto full = tensor.start(as_tensor(state.stress), 1.086);
  const auto flat_prober = stress_prober<Tensor>(tensor, full);
  const IncrementalResponse<Tensor> flat(tensor, full);

  for (double angle = 0.1; angle < 6.28; angle += 0.3) {
    const Probe probe = stress_probe(stress_rate(response, angle)), same = prober(angle);
    REQUIRE(probe.answered);
    CHECK(probe.angle == Approx(angle));
    CHECK((probe.strain - same.strain).norm() < 1e-12 * same.strain.norm());
    CHECK(probe.normalised == Approx(same.normalised).margin(1e-12));

    const auto rate = stress_rate(flat, angle);
    REQUIRE(rate.controllable);
    CHECK(std::abs(rate.strain(1)) < 1e-10 * rate.strain.norm());
    CHECK(stress_probe(rate).normalised == Approx(flat_prober(angle).normalised).margin(1e-9));
  }
}

TEST_CASE("a rate of any size is a probe of its direction") {
  PointRate<Axisymmetric> rate;
  CHECK_FALSE(stress_probe(rate).answered);
  rate.controllable = true;
  CHECK_FALSE(stress_probe(rate).answered);
  rate.stress << 3, 4;  // y, x
  rate.strain << 6e-6, 8e-6;
  const Probe probe = stress_probe(rate);
  CHECK(probe.angle == Approx(std::atan2(3, 4)));
  CHECK(probe.stress.norm() == Approx(1));
  CHECK(probe.second_order_work == Approx(2e-6));
  CHECK(probe.normalised == Approx(1));
}
