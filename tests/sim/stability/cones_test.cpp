#include "sim/stability/cones.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/materials/interpolated_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

Circle circle(const Law<Axisymmetric>& law, double p_kPa, double eta, double e, int directions) {
  return probe_circle(make_prober(std::make_shared<const IncrementalResponse<Axisymmetric>>(
                                      law, state_at(law, p_kPa, eta, e)),
                                  ProbeKind::stress),
                      {.directions = directions});
}

}  // namespace

TEST_CASE("cones of INL2 and octolinear as printed in constitutive.md, section 1.4") {
  const auto law = inl2();
  for (double eta : {0.5, 0.55, 0.6, 0.7, 0.8}) {
    const auto c = circle(law, 70, eta, 1.086, 36);
    for (auto k : c.cones) printf("eta %g: %.4f %.4f\n", eta, k.from / kDegree, k.to / kDegree);
    printf("least %g at %g\n", c.least.normalised, c.least.angle / kDegree);
  }
}
