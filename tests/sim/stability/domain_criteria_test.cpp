// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/domain_criteria.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/sim/stability/domain_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

DomainGrid plane_grid(ProbePlane plane) {
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
      const DomainGrid g = plane_grid(plane);
      const DomainCriteria criteria = domain_criteria(material, g);
      const DomainBoundary found = domain_column(material, g, 1).compression;
      const double q = *found.first_unstable_q;
      REQUIRE(criteria.size() == 1);
      CHECK(criteria[0].name == "determinant");
      CHECK(*criteria[0].witness(120e3, q * (1 - 1e-5)) > 0);
      CHECK(*criteria[0].witness(120e3, q * (1 + 1e-5)) < 0);
    }
}

TEST_CASE("beyond its limit a law has no determinant; without a law there is no criterion") {
  const Material material = interpolated(Interpolation::inl2, kInl2);
  const DomainCriteria criteria = domain_criteria(material, plane_grid(ProbePlane::axisymmetric));
  REQUIRE(criteria.size() == 1);
  CHECK(criteria[0].witness(100e3, 20e3));
  CHECK_FALSE(criteria[0].witness(100e3, 200e3));
  CHECK(domain_criteria({}, plane_grid(ProbePlane::axisymmetric)).empty());
}

TEST_CASE("a criterion that takes long is looked for where it is asked for, in fewer states") {
  const Material material = interpolated(Interpolation::octolinear, kOcto);
  const DomainGrid g = plane_grid(ProbePlane::plane_strain);
  for (const DomainCriterionKind& kind : domain_criterion_kinds()) {
    INFO(kind.name);
    const auto has = [&](const DomainCriteria& criteria) {
      return std::ranges::find(criteria, kind.name, &DomainCriterion::name) != criteria.end();
    };
    CHECK(has(domain_criteria(material, g)) == !kind.on_request());
    CHECK(has(domain_criteria(material, g, {std::string(kind.name)})));
    CHECK((kind.most_rows < 200) == kind.on_request());
  }
}
