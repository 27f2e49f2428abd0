// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/stage_flows.hpp"

#include <catch2/catch.hpp>

#include "sim/materials/sanisand.hpp"
#include "tests/sim/materials/parameter_sets.hpp"

using namespace triax::sim;
using Triaxial = Sanisand<Axisymmetric>;
using Flows = StageFlows<Axisymmetric>;

namespace {

/// Of everything that is integrated, by the same number in its own size.
StageFlow<Axisymmetric> flow(double rate, Eigen::Index memories) {
  StageFlow<Axisymmetric> all;
  all.stress.setConstant(rate * 1e3);
  all.strain.setConstant(rate * 1e-3);
  all.void_ratio = -rate * 1e-2;
  all.memory.setConstant(memories, rate);
  return all;
}

}  // namespace

TEST_CASE("derivatives that do not change are followed along a line, without an error") {
  const Triaxial law(test::s28_general());
  const auto from = law.isotropic(200e3, 1.0);
  const auto memories = from.memory.size();
  REQUIRE(memories > 0);
  for (const Tableau* tableau : {&kImprovedEuler, &kDormandPrince}) {
    Flows flows(*tableau, law, memories);
    for (int i = 0; i < tableau->evaluations; ++i) flows[i] = flow(2, memories);
    PointState<Axisymmetric> at = from;
    Vector<Axisymmetric> strain;
    const int last = tableau->rows - 1;
    flows.move(from, 0.25, last, at, strain);
    CHECK((at.stress - from.stress).isConstant(500, 1e-9));
    CHECK(strain.isConstant(5e-4, 1e-12));
    CHECK(at.void_ratio == Approx(1.0 - 5e-3));
    CHECK((at.memory - from.memory).isConstant(0.5, 1e-12));
    CHECK(flows.error_at(at, 0.25) < 1e-14);
  }
}

TEST_CASE("the error is half of the change of Heun's two slopes, of each in its own size") {
  const Triaxial law(test::s28_general());
  const auto from = law.isotropic(200e3, 1.0);
  const auto memories = from.memory.size();
  Flows flows(kImprovedEuler, law, memories);
  flows[0] = flows[1] = flow(0, memories);
  CHECK(flows.error_at(from, 0.5) == 0);
  flows[1].stress.setConstant(4e3);
  CHECK(flows.error_at(from, 0.5) == Approx(0.5 * 4e3 / 2 / 200e3));
  auto liquefied = from;
  liquefied.stress.setZero();
  CHECK(flows.error_at(liquefied, 0.5) == Approx(0.5 * 4e3 / 2 / Flows::kSmallestStress));
  flows[1].strain(1) = -0.2;
  CHECK(flows.error_at(from, 0.5) == Approx(0.05));
  flows[1].void_ratio = -0.4;
  CHECK(flows.error_at(from, 0.5) == Approx(0.1));
  const int last = static_cast<int>(memories) - 1;
  flows[1].memory(last) = 8 * law.memory_scale(last);
  CHECK(flows.error_at(from, 0.5) == Approx(2));
}
