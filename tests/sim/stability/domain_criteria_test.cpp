#include "sim/stability/domain_criteria.hpp"

#include <catch2/catch.hpp>

#include "tests/sim/stability/domain_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

DomainGrid grid(ProbePlane plane) {
  return {.p_from = 60e3,
          .p_to = 120e3,
          .columns = 2,
          .q_from = 0,
          .q_to = 150e3,
          .rows = 30,
          .void_ratio = 1.086,
          .plane = plane,
          .directions = 90};
}

}  // namespace

TEST_CASE("the determinant changes sign where the probing finds the first unstable state") {
  for (const auto kind : {Interpolation::inl2, Interpolation::octolinear})
    for (const auto plane : {ProbePlane::axisymmetric, ProbePlane::plane_strain}) {
      const Material material = interpolated(kind, kind == Interpolation::inl2 ? kInl2 : kOcto);
      const DomainGrid g = grid(plane);
      const DomainCriteria criteria = domain_criteria(material, g);
      const DomainBoundary found = domain_column(material, g, 1).compression;
      const double q = *found.first_unstable_q;
      CHECK(*criteria.determinant(120e3, q * (1 - 1e-5)) > 0);
      CHECK(*criteria.determinant(120e3, q * (1 + 1e-5)) < 0);
    }
}

TEST_CASE("beyond its limit a law has no determinant; without a law there is no criterion") {
  const Material material = interpolated(Interpolation::inl2, kInl2);
  const DomainCriteria criteria = domain_criteria(material, grid(ProbePlane::axisymmetric));
  CHECK(criteria.determinant(100e3, 20e3));
  CHECK_FALSE(criteria.determinant(100e3, 200e3));
  CHECK_FALSE(domain_criteria({}, grid(ProbePlane::axisymmetric)).determinant);
}
