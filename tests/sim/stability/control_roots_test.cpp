// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/control_roots.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "sim/stability/cones.hpp"
#include "sim/stability/controllability.hpp"
#include "tests/sim/materials/interpolated_laws.hpp"
#include "tests/sim/stability/stability_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

PointState<Tensor> plane_state(const Law<Tensor>& material, double eta, double e) {
  return material.start(as_tensor(state_at(octo(), 70, eta, e).stress), e);
}

std::vector<ControlRoot> roots_in_zones(const Law<Tensor>& material, const PointState<Tensor>& s) {
  return control_roots(octolinear_zones(std::get<InterpolatedForm<Tensor>>(material.response(s))));
}

/// Edges of the cones, as probes around the circle find them, in [0, 2π), sorted.
std::vector<double> edges_by_probes(const Prober& prober) {
  std::vector<double> edges;
  for (const Cone& cone : probe_circle(prober, {.directions = 72}).cones)
    for (const double edge : {cone.from, cone.to})
      edges.push_back(std::fmod(edge, 2 * std::numbers::pi));
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<double> angles_of(const std::vector<ControlRoot>& roots) {
  std::vector<double> angles;
  for (const ControlRoot& root : roots) angles.push_back(root.angle);
  std::sort(angles.begin(), angles.end());
  return angles;
}

bool apart(const std::vector<double>& edges) {
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i] - edges[i - 1] < 1e-3) return false;
  return true;
}

/// One angle for each edge.
void check_same(const std::vector<double>& roots, const std::vector<double>& edges) {
  REQUIRE(roots.size() == edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) CHECK(std::abs(roots[i] - edges[i]) < 1e-7);
}

}  // namespace

TEST_CASE("Eq. 35 has its roots in zone (-, +, -) where sigma2 rises, and control ends there") {
  const auto material = law<Tensor>(Interpolation::octolinear, kOcto);
  for (const double eta : {0.68, 0.8}) {
    CAPTURE(eta);
    const auto s = plane_state(material, eta, 1.086);
    const auto roots = roots_in_zones(material, s);
    REQUIRE(roots.size() == 2);
    for (const ControlRoot& root : roots) {
      REQUIRE(root.zone);
      CHECK_FALSE(root.zone->loading[0]);
      CHECK(root.zone->loading[1]);
      CHECK_FALSE(root.zone->loading[2]);
    }
    // The moduli of (−, −, −) have none at 0.68, and at 0.8 others: 0.468 and 1.114.
    const auto form = std::get<InterpolatedForm<Tensor>>(material.response(s));
    const auto wrong = plane_compliance(principal_moduli(zone_compliance(form, ZoneSigns{})));
    for (const double R : control_quadratic(wrong).roots())
      for (const ControlRoot& root : roots) CHECK(std::abs(R - root.R) > 0.1);
    CHECK(control_quadratic(wrong).roots().size() == (eta < 0.7 ? 0 : 2));
    // Found without any zone: the control of every R tried in turn.
    const IncrementalResponse<Tensor> response(material, s);
    const auto lost = lost_control(response, 0.05, 5).lost;
    REQUIRE(lost.size() == 1);
    CHECK(lost[0].from == Approx(roots[0].R).epsilon(1e-7));
    CHECK(lost[0].to == Approx(roots[1].R).epsilon(1e-7));
  }
}

TEST_CASE("the roots of all zones are the edges of the cones, in plane strain and axisymmetry") {
  const auto material = law<Tensor>(Interpolation::octolinear, kOcto);
  int edges = 0, across = 0;
  for (const double e : {0.85, 1.0, 1.086})
    for (double eta = 0.05; eta < 1.2; eta += 0.05)
      for (const double share : {0.0, 0.3, 0.8}) {  // of σ₂ between σ₃ and σ₁
        const double p = 70e3, q = eta * p, radial = p - q * (1 + share) / 3;
        const auto s = material.start(
            (Vector<Tensor>() << radial + q, radial + share * q, radial, 0, 0, 0).finished(), e);
        if (material.objection(s)) continue;
        const auto form = std::get<InterpolatedForm<Tensor>>(material.response(s));
        if (!answers_in_plane_strain(form)) continue;
        const auto expected = edges_by_probes(stress_prober<Tensor>(material, s));
        if (!apart(expected)) continue;
        CAPTURE(e, eta, share);
        const auto roots = roots_in_zones(material, s);
        check_same(angles_of(roots), expected);
        edges += static_cast<int>(expected.size());
        for (const ControlRoot& root : roots) across += root.zone->loading[1];
      }
  CHECK(edges > 50);
  CHECK(across > 20);
  const auto triaxial = octo();
  for (const double eta : {-0.7, 0.3, 0.6, 0.9}) {
    const auto s = state_at(triaxial, 70, eta, 1.086);
    check_same(angles_of(control_roots(octolinear_zones(moduli(triaxial, s)))),
               edges_by_probes(stress_prober<Axisymmetric>(triaxial, s)));
  }
}

TEST_CASE("of any law a root is that of the tangent of its own direction") {
  int roots = 0;
  for (const auto& [name, material] : stability_laws())
    for (const double eta : {0.3, 0.6, 0.75}) {
      CAPTURE(name, eta);
      const auto s = state_at(*material, 70, eta, 1.086);
      const IncrementalResponse<Axisymmetric> response(*material, s);
      const auto found = control_roots(response);
      for (const ControlRoot& root : found) {
        ++roots;
        // Read from the law itself: W₂ = 0 there, and the mode's strains obey Eq. (40).
        const auto rate = response.to_stress(components(
            AxisymmetricStress{std::sin(root.angle), std::cos(root.angle) / std::numbers::sqrt2}));
        REQUIRE(rate.controllable);
        CHECK(std::abs(rate.normalised_work()) < 1e-7);
        const auto stress = axisymmetric_stress(rate.stress);
        CHECK(stress.radial / stress.axial == Approx(root.R).epsilon(1e-8));
        CHECK(rate.strain(0) / stress.radial == Approx(root.failure_rule).epsilon(1e-5));
      }
      check_same(angles_of(found), edges_by_probes(stress_prober<Axisymmetric>(*material, s)));
    }
  CHECK(roots > 8);
}
