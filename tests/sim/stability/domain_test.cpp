// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/domain.hpp"

#include <catch2/catch.hpp>

#include "sim/point/point_driver.hpp"
#include "sim/stability/domain_criteria.hpp"
#include "tests/sim/stability/domain_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

DomainGrid grid(double q_from_kPa, double q_to_kPa, int rows,
                ProbePlane plane = ProbePlane::axisymmetric) {
  return {.p_from = 50e3,
          .p_to = 150e3,
          .columns = 3,
          .q_from = 1e3 * q_from_kPa,
          .q_to = 1e3 * q_to_kPa,
          .rows = rows,
          .void_ratio = 1.086,
          .plane = plane,
          .directions = 90};
}

template <class Space>
Circle circle(const Law<Space>& law, double p, double q, double e) {
  return probe_circle(make_prober(std::make_shared<const IncrementalResponse<Space>>(
                                      law, law.start(domain_stress<Space>(p, q), e)),
                                  ProbeKind::stress),
                      {.directions = 90});
}

void check_against_probes(const Law<Axisymmetric>& law) {
  const DomainGrid g = grid(-90, 130, 23);
  for (int column = 0; column < g.columns; ++column) {
    const DomainColumn found = domain_column(law, g, column);
    REQUIRE(found.states.size() == 23);
    for (std::size_t row = 0; row < found.states.size(); ++row) {
      const DomainState& state = found.states[row];
      INFO("p " << found.p << " q " << state.q);
      CHECK(found.p == g.p(column));
      CHECK(state.q == g.q(static_cast<int>(row)));
      const auto alone = law.start(domain_stress<Axisymmetric>(found.p, state.q), 1.086);
      if (law.objection(alone)) {
        CHECK(state.kind == DomainStateKind::beyond_limit);
        CHECK_FALSE(state.least_work);
        continue;
      }
      // Another way to the same numbers: control of both stresses by the point's own solver.
      const auto work = [&](double angle) {
        const PlaneVector v = unit_direction(angle);
        return point_rate(law, alone, MixedControl<Axisymmetric>::stresses({v.y(), v.x()}))
            .normalised_work();
      };
      double least = 1;
      for (int i = 0; i < g.directions; ++i)
        least = std::min(least, work(2 * std::numbers::pi * i / g.directions));
      REQUIRE(state.least_work);
      CHECK(*state.least_work <= least + 1e-12);
      CHECK(*state.least_work > least - 2e-2);  // a step of 4 degrees at most away
      CHECK(work(*state.least_angle) == Approx(*state.least_work).margin(1e-10));
      CHECK((state.kind == DomainStateKind::unstable) == !state.cones.empty());
      if (state.cones.empty()) CHECK(least > kUnstable);
      for (const Sector& cone : state.cones) {
        CHECK(work((cone.from + cone.to) / 2) < 0);
        for (const double edge : {cone.from, cone.to}) CHECK(work(edge) == Approx(0).margin(1e-8));
      }
    }
  }
}

/// No direction of negative second-order work on this side of the limit.
void check_stable(const Law<Axisymmetric>& law, double q_from_kPa, double q_to_kPa, bool limit) {
  for (int column = 0; column < 3; ++column) {
    const auto found = domain_column(law, grid(q_from_kPa, q_to_kPa, 30), column);
    for (const DomainState& state : found.states) {
      CHECK((state.kind == DomainStateKind::stable || state.kind == DomainStateKind::beyond_limit));
      if (state.least_work) CHECK(*state.least_work > -1e-12);
    }
    for (const DomainBoundary& side : {found.compression, found.extension}) {
      CHECK_FALSE(side.first_unstable_q);
      CHECK_FALSE(side.isotropic_unloading_q);
    }
    CHECK(found.compression.limit_q.has_value() == limit);
  }
}

constexpr double kSine = 0.5;  // of kThirtyDegrees

}  // namespace

TEST_CASE("grids of INL2 and octolinear agree with the solver of mixed control") {
  check_against_probes(inl2());
  check_against_probes(octo());
}

TEST_CASE("the first unstable state of the grid is that of its own probes, isolated") {
  const auto laws = {inl2(), octo()};
  for (const auto& law : laws) {
    const auto found = domain_column(law, grid(-100, 130, 47), 1);
    for (const auto* side : {&found.compression, &found.extension}) {
      REQUIRE(side->first_unstable_q);
      const double q = *side->first_unstable_q;
      CHECK(circle(law, found.p, q * (1 - 1e-8), 1.086).least.normalised > 0);
      const Circle beyond = circle(law, found.p, q * (1 + 1e-8), 1.086);
      REQUIRE(beyond.unstable());
      CHECK(beyond.cones.size() == 1);
      CHECK(beyond.cones[0].contains(*side->first_unstable_angle));
      CHECK(beyond.cones[0].opening() < 1e-3);
      // The order in which the criteria are met going outwards.
      REQUIRE(side->isotropic_unloading_q);
      CHECK(std::abs(*side->isotropic_unloading_q) > std::abs(q));
      REQUIRE(side->limit_q);
      CHECK(std::abs(*side->limit_q) > std::abs(*side->isotropic_unloading_q));
    }
    CHECK(*found.compression.first_unstable_q > 0);
    CHECK(*found.extension.first_unstable_q < 0);
  }
}

TEST_CASE("a boundary does not depend on the rows between which it is found") {
  const auto law = inl2();
  const auto coarse = domain_column(law, grid(0, 130, 14), 1).compression;
  const auto fine = domain_column(law, grid(0, 137, 61), 1).compression;
  CHECK(*coarse.first_unstable_q == Approx(*fine.first_unstable_q).epsilon(1e-8));
  CHECK(*coarse.isotropic_unloading_q == Approx(*fine.isotropic_unloading_q).epsilon(1e-9));
  CHECK(*coarse.limit_q == Approx(*fine.limit_q).epsilon(1e-9));
}

TEST_CASE("at the isotropic unloading line the volume stands still") {
  const auto law = inl2();
  const auto found = domain_column(law, grid(0, 130, 27), 1);
  const IncrementalResponse<Axisymmetric> response(
      law, law.start(domain_stress<Axisymmetric>(found.p, *found.compression.isotropic_unloading_q),
                     1.086));
  const auto rate = response.to_stress(-isotropic<Axisymmetric>(1));
  CHECK(std::abs(trace<Axisymmetric>(rate.strain)) < 1e-8 * rate.strain.norm());
}

TEST_CASE("the limit of the interpolated laws is where their base has its bounding surface") {
  const auto law = inl2();
  const auto found = domain_column(law, grid(0, 130, 27), 1);
  const double q = *found.compression.limit_q;
  const auto at = [&](double part) {
    return law.objection(law.start(domain_stress<Axisymmetric>(found.p, q * part), 1.086));
  };
  CHECK_FALSE(at(1 - 1e-9));
  CHECK(at(1 + 1e-9));
}

TEST_CASE("the determinant of octolinear and of INL2 vanishes at the first unstable state") {
  for (const auto plane : {ProbePlane::axisymmetric, ProbePlane::plane_strain}) {
    const Material octolinear = interpolated(Interpolation::octolinear, kOcto);
    const DomainGrid g = grid(0, 130, 40, plane);
    const auto column = domain_column(octolinear, g, 1, domain_criteria(octolinear, g));
    REQUIRE(column.compression.other_q("determinant"));
    CHECK(*column.compression.other_q("determinant") ==
          Approx(*column.compression.first_unstable_q).epsilon(1e-8));
  }
  const Material nonlinear{std::make_shared<Interpolated<Axisymmetric>>(inl2()), {}, {}, {}};
  const DomainGrid g = grid(0, 130, 40);
  const auto column = domain_column(nonlinear, g, 1, domain_criteria(nonlinear, g));
  CHECK(*column.compression.other_q("determinant") ==
        Approx(*column.compression.first_unstable_q).epsilon(1e-7));
}

TEST_CASE("elasticity is stable everywhere and has no limit") {
  check_stable(Elastic<Axisymmetric>(elasticity()), -120, 300, false);
}

TEST_CASE("associated plasticity has no unstable state before its limit") {
  const auto cone = frictional<DruckerPragerParameters>(kThirtyDegrees);
  check_stable(DruckerPrager<Axisymmetric>(cone), -50, 300, true);
  const MohrCoulomb<Axisymmetric> mohr_coulomb(frictional<MohrCoulombParameters>(kThirtyDegrees));
  check_stable(mohr_coulomb, -50, 300, true);
  // q/p′ = 6 sin φ/(3 ∓ sin φ)
  const auto column = domain_column(mohr_coulomb, grid(-200, 300, 101), 1);
  CHECK(*column.compression.limit_q / column.p == Approx(6 * kSine / (3 - kSine)).epsilon(1e-8));
  CHECK(*column.extension.limit_q / column.p == Approx(-6 * kSine / (3 + kSine)).epsilon(1e-8));
}

TEST_CASE("Cam-clay is stable up to the critical state line, which is its limit") {
  const CamClay<Axisymmetric> law(clay());
  check_stable(law, -50, 300, true);
  const auto column = domain_column(law, grid(0, 300, 40), 1);
  CHECK(*column.compression.limit_q / column.p == Approx(1.2).epsilon(1e-8));
}

TEST_CASE("a non-associated cone is unstable on its surface only, as perfect plasticity is") {
  const auto cone = frictional<DruckerPragerParameters>(0);
  const auto column = domain_column(DruckerPrager<Axisymmetric>(cone), grid(0, 300, 40), 1);
  REQUIRE(column.compression.limit_q);
  CHECK_FALSE(column.compression.first_unstable_q);
}

TEST_CASE("a domain of a law without a size is the same at every stress") {
  // All moduli of Cam-clay go with p′: only η counts.
  const CamClay<Axisymmetric> law(clay());
  DomainGrid g = grid(0, 90, 10);
  const DomainColumn low = domain_column(law, g, 1);
  g.p_from *= 8, g.p_to *= 8, g.q_from *= 8, g.q_to *= 8;
  const DomainColumn high = domain_column(law, g, 1);
  for (std::size_t i = 0; i < low.states.size(); ++i) {
    CHECK(low.states[i].kind == high.states[i].kind);
    if (low.states[i].least_work)
      CHECK(*low.states[i].least_work == Approx(*high.states[i].least_work).epsilon(1e-10));
  }
}

TEST_CASE("in plane strain the limit is still that of all stresses") {
  const Sanisand<Axisymmetric> triaxial(s28_general());
  const Sanisand<Tensor> tensor(s28_general());
  const auto axisymmetric = domain_column(triaxial, grid(0, 140, 29), 1);
  const auto plane_strain = domain_column(tensor, grid(0, 140, 29, ProbePlane::plane_strain), 1);
  REQUIRE(plane_strain.compression.limit_q);
  CHECK(*plane_strain.compression.limit_q ==
        Approx(*axisymmetric.compression.limit_q).epsilon(1e-8));
}

TEST_CASE(
    "a state of which a law refuses directions is unknown, and its gaps are no plastic limit") {
  const NorSand law(nerlerk_drained());
  DomainGrid g = grid(0, 280, 15);
  g.void_ratio = 0.8;
  const auto column = domain_column(law, g, 1);
  bool gap = false;
  for (const DomainState& state : column.states) {
    INFO("q " << state.q);
    CHECK(state.kind != DomainStateKind::stable);
    CHECK(state.kind != DomainStateKind::beyond_limit);
    if (state.kind != DomainStateKind::unknown) continue;
    CHECK(state.refused_directions > 0);
    REQUIRE(state.least_work);
    CHECK(*state.least_work > kUnstable);
    CHECK(state.cones.empty());
    const Circle c = circle(law, column.p, state.q, 0.8);
    gap = gap || c.unanswered > c.refused;
  }
  CHECK(gap);
  CHECK_FALSE(column.compression.limit_q);
}

namespace {

/// Elastic, at its limit between two stress ratios and fine again behind.
class Islands : public Elastic<Axisymmetric> {
 public:
  Islands() : Elastic(elasticity()) {}
  std::optional<std::string> objection(const State& s) const override {
    if (at_limit(s)) return "too steep";
    return Elastic::objection(s);
  }
  bool at_limit(const State& s) const override {
    return s.q() > 0.47 * s.p() && s.q() < 0.96 * s.p();
  }
};

/// Octolinear without a meaning at this void ratio, whatever its limit says.
class NoVoidRatio : public Elastic<Axisymmetric> {
 public:
  NoVoidRatio() : Elastic(elasticity()) {}
  std::optional<std::string> objection(const State&) const override { return "too loose"; }
  bool at_limit(const State&) const override { return true; }
};

}  // namespace

TEST_CASE("nothing behind the limit is stable, whatever the law answers there") {
  const auto column = domain_column(Islands(), grid(0, 150, 16), 1);
  REQUIRE(column.compression.limit_q);
  CHECK(*column.compression.limit_q == Approx(0.47 * column.p).epsilon(1e-8));
  for (const DomainState& state : column.states) {
    const bool beyond = state.q > 0.47 * column.p;
    CHECK(state.kind == (beyond ? DomainStateKind::beyond_limit : DomainStateKind::stable));
    CHECK(state.least_work.has_value() == !beyond);
  }
}

TEST_CASE("a criterion that is met only where the limit is, is not met before it") {
  DomainCriteria criteria;
  const auto met_at = [](double eta) {
    return [eta](double p, double q) { return std::optional(eta * p - q); };
  };
  criteria.push_back({"late", met_at(0.47 * (1 - 1e-7))});
  criteria.push_back({"early", met_at(0.46)});
  const auto column = domain_column(Islands(), grid(0, 150, 16), 1, criteria).compression;
  REQUIRE(column.limit_q);
  CHECK_FALSE(column.other_q("late"));
  CHECK(column.other_q("early").has_value());
}

TEST_CASE("an objection that the isotropic state raises too is not that of the limit") {
  const auto column = domain_column(NoVoidRatio(), grid(0, 150, 4), 1);
  for (const DomainState& state : column.states) CHECK(state.kind == DomainStateKind::refused);
  CHECK(column.refusal == "too loose");
}

TEST_CASE("boundaries below the first row are found, of a grid that lies beyond the limit too") {
  const auto law = inl2();
  const auto whole = domain_column(law, grid(0, 130, 14), 1);
  for (const double from_kPa : {60.0, 100.0, 125.0}) {
    const auto above = domain_column(law, grid(from_kPa, 300, 9), 1);
    REQUIRE(above.compression.first_unstable_q);
    CHECK(*above.compression.first_unstable_q ==
          Approx(*whole.compression.first_unstable_q).epsilon(1e-8));
    CHECK(*above.compression.isotropic_unloading_q ==
          Approx(*whole.compression.isotropic_unloading_q).epsilon(1e-9));
    CHECK(*above.compression.limit_q == Approx(*whole.compression.limit_q).epsilon(1e-9));
    CHECK_FALSE(above.extension.first_unstable_q);  // no row on that side
  }
  const auto beyond = domain_column(law, grid(250, 300, 3), 1);
  for (const DomainState& state : beyond.states) CHECK(state.kind == DomainStateKind::beyond_limit);
  CHECK(beyond.compression.limit_q);
}

TEST_CASE("what a law refuses is told as that, with its words, and ends the search") {
  SanisandParameters p = s28_general();
  p.hardening_void_ratio_factor = 1.0;  // no hardening from e = 1 on
  const auto column = domain_column(Sanisand<Axisymmetric>(p), grid(0, 130, 10), 0);
  for (const DomainState& state : column.states) CHECK(state.kind == DomainStateKind::refused);
  CHECK(column.refusal.find("void ratio is 1.086") != std::string::npos);
  CHECK_FALSE(column.compression.limit_q);
  CHECK_FALSE(column.compression.first_unstable_q);
}

TEST_CASE("criteria of other kinds are isolated too, and silence is not meeting them") {
  const auto law = inl2();
  DomainCriteria criteria;
  criteria.push_back({"some", [](double p, double q) -> std::optional<double> {
                        if (q < 0.2 * p) return std::nullopt;
                        return 0.4321 * p - q;
                      }});
  const auto column = domain_column(law, grid(-60, 130, 39), 1, criteria);
  CHECK(*column.compression.other_q("some") == Approx(0.4321 * column.p).epsilon(1e-9));
  CHECK_FALSE(column.extension.other_q("some"));
  CHECK(column.compression.others_q.size() == 1);
}

TEST_CASE("a material without a form for the plane is refused in words") {
  const Material material{std::make_shared<Interpolated<Axisymmetric>>(inl2()), {}, "why not", {}};
  CHECK_THROWS_WITH(domain_column(material, grid(0, 10, 2, ProbePlane::plane_strain), 0),
                    "why not");
}

TEST_CASE("a grid has its ends exactly") {
  const DomainGrid g{
      .p_from = 0.1, .p_to = 0.7, .columns = 7, .q_from = -0.3, .q_to = 0.9, .rows = 13};
  CHECK(g.p(0) == 0.1);
  CHECK(g.p(6) == 0.7);
  CHECK(g.q(0) == -0.3);
  CHECK(g.q(12) == 0.9);
  CHECK(g.q(3) == Approx(0).margin(1e-15));
}
