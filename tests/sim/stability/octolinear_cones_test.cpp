// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/octolinear_cones.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/sim/materials/random_tensors.hpp"
#include "tests/sim/stability/first_loss.hpp"
#include "tests/sim/stability/random_compliances.hpp"
#include "tests/sim/stability/stability_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::vector<OctolinearZone> zones_at(double p_kPa, double eta, double e) {
  const auto material = octo();
  return octolinear_zones(moduli(material, state_at(material, p_kPa, eta, e)));
}

/// The closed form against the probes around the circle. Where W₂ has just become negative the
/// probes' allowance for round-off (kUnstable) moves their edges, so narrow cones are left out.
int check_zones_against_probes(const std::vector<OctolinearZone>& zones, const Prober& prober) {
  const Circle circle = probe_circle(prober, {.directions = 72});
  const auto sectors = unstable_sectors(zones);
  CHECK((least_work(zones) < 0) == !sectors.empty());
  for (const auto& s : sectors)
    if (s.to - s.from < 1e-3) return 0;
  REQUIRE(circle.cones.size() == sectors.size());
  for (std::size_t i = 0; i < sectors.size(); ++i) {
    CHECK(std::abs(circle.cones[i].from - sectors[i].from) < 1e-8);
    CHECK(std::abs(circle.cones[i].to - sectors[i].to) < 1e-8);
  }
  for (const Probe& probe : circle.probes)
    for (const auto& zone : zones)
      if (probe.answered && zone.contains(probe.angle))
        CHECK(std::abs(zone.compliance.work(probe.angle) - probe.second_order_work) <
              1e-12 * zone.compliance.matrix.norm());
  return static_cast<int>(sectors.size());
}

double covered(const std::vector<OctolinearZone>& zones) {
  double sum = 0;
  for (const auto& zone : zones) sum += zone.to - zone.from;
  return sum;
}

/// A law whose compliances are given, whatever the state.
template <class Space>
class Given : public GeneralisedTriaxial<Space> {
 public:
  Matrix<Space> plus, minus;
  void moduli(const PointState<Space>&, Matrix<Space>& p, Matrix<Space>& m) const override {
    p = plus;
    m = minus;
  }
};

}  // namespace

TEST_CASE("cones of octolinear as printed in constitutive.md, section 1.4") {
  const std::vector<std::array<double, 3>> printed{
      {0.55, 223.5, 233}, {0.60, 215.5, 243}, {0.70, 209, 252.5}};
  for (const auto& [eta, first, last] : printed) {
    const auto sectors = unstable_sectors(zones_at(70, eta, 1.086));
    REQUIRE(sectors.size() == 1);
    // On a grid of half degrees.
    CHECK(std::ceil(sectors[0].from / kDegree * 2) / 2 == first);
    CHECK(std::floor(sectors[0].to / kDegree * 2) / 2 == last);
  }
  CHECK(unstable_sectors(zones_at(70, 0.4, 1.086)).empty());
}

TEST_CASE("octolinear's cones in axisymmetry are those that probes find") {
  const auto material = octo();
  int cones = 0;
  for (const double e : {0.75, 0.9, 1.0, 1.086, 1.15})
    for (double eta = -0.75; eta < 1.25; eta += 0.05) {
      const auto s = state_at(material, 70, eta, e);
      if (material.objection(s)) continue;
      cones += check_zones_against_probes(octolinear_zones(moduli(material, s)),
                                          stress_prober<Axisymmetric>(material, s));
    }
  CHECK(cones > 50);
}

TEST_CASE("octolinear's cones in plane strain are those that probes find") {
  const auto material = law<Tensor>(Interpolation::octolinear, kOcto);
  int cones = 0;
  for (const double e : {0.85, 1.0, 1.086})
    for (double eta = 0.05; eta < 1.2; eta += 0.05)
      for (const double share : {0.0, 0.3}) {  // of σ₂ between σ₃ and σ₁
        const double p = 70e3, q = eta * p;
        const double radial = p - q * (1 + share) / 3;
        const auto s = material.start(
            (Vector<Tensor>() << radial + q, radial + share * q, radial, 0, 0, 0).finished(), e);
        if (material.objection(s)) continue;
        const auto form = std::get<InterpolatedForm<Tensor>>(material.response(s));
        if (!answers_in_plane_strain(form)) continue;
        const auto zones = octolinear_zones(form);
        cones += check_zones_against_probes(zones, stress_prober<Tensor>(material, s));
        CHECK(covered(zones) == Approx(2 * std::numbers::pi));
      }
  CHECK(cones > 20);
}

TEST_CASE("any octolinear response: cones that cross zones, two cones, cones through α = 0") {
  RandomCompliances random;
  int cones = 0, across_zones = 0, through_zero = 0, twofold = 0;
  for (int i = 0; i < 300; ++i) {
    const auto base = std::make_shared<Given<Axisymmetric>>();
    // Only where a diagonal entry is negative does a cone reach the edge of a zone.
    for (Matrix<Axisymmetric>* side : {&base->plus, &base->minus})
      for (int k = 0; k < 4; ++k) (*side)(k) = random.uniform(-1, 2) * 1e-7;
    const Interpolated<Axisymmetric> material(Interpolation::octolinear, base);
    const auto zones = octolinear_zones(moduli(material, material.isotropic(1e5, 1)));
    const auto sectors = unstable_sectors(zones);
    for (const auto& s : sectors) {
      through_zero += s.to > 2 * std::numbers::pi;
      across_zones += std::floor(s.from / (90 * kDegree)) != std::floor(s.to / (90 * kDegree));
    }
    twofold += sectors.size() > 1;
    cones += check_zones_against_probes(
        zones, stress_prober<Axisymmetric>(material, material.isotropic(1e5, 1)));
  }
  CHECK(cones > 100);
  CHECK(across_zones > 10);
  CHECK(through_zero > 10);
  CHECK(twofold > 10);
}

TEST_CASE("zones cover the circle once, with dσ2 of its sign") {
  const auto material = law<Tensor>(Interpolation::octolinear, kOcto);
  const auto s = material.start(as_tensor(state_at(octo(), 70, 0.5, 1.0).stress), 1.0);
  REQUIRE(answers_in_plane_strain(std::get<InterpolatedForm<Tensor>>(material.response(s))));
  const IncrementalResponse<Tensor> response(material, s);
  const auto zones = octolinear_zones(std::get<InterpolatedForm<Tensor>>(material.response(s)));
  double edge = 0;
  for (const auto& zone : zones) {
    CHECK(zone.from == Approx(edge).margin(1e-14));
    edge = zone.to;
    MixedControl<Tensor> control;
    const PlaneVector v = unit_direction((zone.from + zone.to) / 2);
    control.increment << v.y(), 0, v.x(), 0, 0, 0;
    for (int free : {0, 2}) control.stress(free, free) = 1;
    for (int fixed : {1, 3, 4, 5}) control.strain(fixed, fixed) = 1;
    const auto rate = response.to(control);
    REQUIRE(rate.controllable);
    CHECK((rate.stress(1) > 0) == zone.signs.loading[1]);
  }
  CHECK(edge == Approx(2 * std::numbers::pi));
  CHECK(zones.size() > 4);
}

TEST_CASE("the edges of the cones are the roots of Eq. 34 whose direction lies in their zone") {
  const auto zones = zones_at(70, 0.6, 1.086);
  std::vector<double> expected, edges;
  for (const auto& zone : zones)
    for (const double R : control_quadratic(zone.compliance).roots()) {
      const double alpha = failure_angle(ProbePlane::axisymmetric, R);
      for (const double angle : {alpha, alpha + std::numbers::pi})
        if (zone.contains(angle)) expected.push_back(angle);
    }
  for (const auto& cone : unstable_sectors(zones)) edges.insert(edges.end(), {cone.from, cone.to});
  std::sort(expected.begin(), expected.end());
  REQUIRE(edges.size() == 2);
  REQUIRE(expected.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) CHECK(edges[i] == Approx(expected[i]).epsilon(1e-12));
}

TEST_CASE("the boundary by the determinant is where the first probe is unstable") {
  const auto line = [](double eta) { return zones_at(70, eta, 1.086); };
  const auto by_determinant =
      first_loss([&](double eta) { return least_determinant(line(eta)); }, 0, 1);
  const auto by_work = first_loss([&](double eta) { return least_work(line(eta)); }, 0, 1);
  REQUIRE(by_determinant);
  REQUIRE(by_work);
  CHECK(*by_determinant == Approx(*by_work).margin(1e-9));
  CHECK(*by_determinant > 0.5);
  CHECK(*by_determinant < 0.55);
  // Double root of Eq. 34, in zone (−, −).
  const auto zone = line(*by_determinant)[2];
  const Quadratic f = control_quadratic(zone.compliance);
  CHECK(std::abs(f.discriminant()) < 1e-9 * f.b * f.b);
  CHECK(zone.contains(failure_angle(ProbePlane::axisymmetric, f.double_root()) + std::numbers::pi));
  CHECK_FALSE(first_loss([&](double eta) { return least_determinant(line(eta)); }, 0, 0.4));
}

TEST_CASE("a state whose N22 is negative on one side has no zones for some directions") {
  InterpolatedForm<Tensor> form;
  form.quadratic = false;
  form.plus = form.minus = isotropic_stiffness<Tensor>(2e7, 1e7).inverse();
  CHECK(answers_in_plane_strain(form));
  CHECK(covered(octolinear_zones(form)) == Approx(2 * std::numbers::pi));
  form.minus(1, 1) *= -1;
  CHECK_FALSE(answers_in_plane_strain(form));
  const auto zones = octolinear_zones(form);
  // With dσ₁, dσ₃ > 0 both signs of dσ₂ keep dε₂ = 0; with both negative none does.
  const auto holding = [&](double angle) {
    return std::count_if(zones.begin(), zones.end(),
                         [=](const OctolinearZone& z) { return z.contains(angle); });
  };
  CHECK(holding(45 * kDegree) == 2);
  CHECK(holding(225 * kDegree) == 0);
}

TEST_CASE("the boundary in plane strain, by the determinant of Ps and by the least W2") {
  const auto material = law<Tensor>(Interpolation::octolinear, kOcto);
  const auto line = [&material](double eta) {
    const auto s = material.start(as_tensor(state_at(octo(), 70, eta, 1.086).stress), 1.086);
    return octolinear_zones(std::get<InterpolatedForm<Tensor>>(material.response(s)));
  };
  const auto by_determinant =
      first_loss([&](double eta) { return least_determinant(line(eta)); }, 0.05, 1);
  const auto by_work = first_loss([&](double eta) { return least_work(line(eta)); }, 0.05, 1);
  REQUIRE(by_determinant);
  REQUIRE(by_work);
  CHECK(*by_determinant == Approx(*by_work).margin(1e-9));
  // Double root of Eq. 35, in a zone that holds the direction.
  int holding = 0;
  for (const auto& zone : line(*by_determinant)) {
    const Quadratic f = control_quadratic(zone.compliance);
    if (std::abs(f.discriminant()) > 1e-9 * f.b * f.b) continue;
    const double alpha = failure_angle(ProbePlane::plane_strain, f.double_root());
    holding += zone.contains(alpha) || zone.contains(alpha + std::numbers::pi);
  }
  CHECK(holding == 1);
}
