// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/control_roots.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "sim/stability/cones.hpp"
#include "sim/stability/controllability.hpp"
#include "sim/stability/octolinear_cones.hpp"
#include "sim/stability/plane_rate.hpp"
#include "tests/sim/materials/interpolated_laws.hpp"
#include "tests/sim/stability/stability_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

PointState<Tensor> plane_state(const Law<Tensor>& material, double eta, double e) {
  return material.start(as_tensor(state_at(octo(), 70, eta, e).stress), e);
}

/// Eq. (34), (35) with the moduli of every zone: those roots whose directions lie in it.
struct ClosedForm {
  double R = 0, angle = 0, failure_rule = 0;
  ZoneSigns zone;
};
std::vector<ClosedForm> closed_form(const std::vector<OctolinearZone>& zones) {
  std::vector<ClosedForm> roots;
  for (const OctolinearZone& zone : zones)
    for (const double R : control_quadratic(zone.compliance).roots())
      for (const double turn : {0.0, std::numbers::pi}) {
        const double angle = failure_angle(zone.compliance.plane, R) + turn;
        const auto known = [angle](const ClosedForm& r) {
          return std::abs(std::remainder(r.angle - angle, 2 * std::numbers::pi)) < 1e-9;
        };
        if (zone.contains(angle) && std::ranges::none_of(roots, known))
          roots.push_back({R, angle, failure_rule(zone.compliance, R), zone.signs});
      }
  std::ranges::sort(roots, {}, &ClosedForm::R);
  return roots;
}

template <class Space>
std::vector<OctolinearZone> zones_of(const IncrementalResponse<Space>& response) {
  return octolinear_zones(std::get<InterpolatedForm<Space>>(response.response()));
}

bool roots_apart(const std::vector<ClosedForm>& roots) {
  for (std::size_t i = 0; i < roots.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(roots[i].angle - roots[j].angle) < 1e-3) return false;
  return true;
}

/// How many of them there are, all alike.
template <class Space>
int check_closed_form(const IncrementalResponse<Space>& response) {
  const auto expected = closed_form(zones_of(response));
  if (!roots_apart(expected)) return 0;
  const auto roots = control_roots(response).roots;
  REQUIRE(roots.size() == expected.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    CHECK(roots[i].R == Approx(expected[i].R).epsilon(1e-8));
    CHECK(std::abs(roots[i].angle - expected[i].angle) < 1e-9);
    CHECK(roots[i].failure_rule == Approx(expected[i].failure_rule).epsilon(1e-7));
  }
  return static_cast<int>(roots.size());
}

/// A law of two unknowns whose directions beyond a limit have no answer: elasticity that fails
/// where the specimen is to get wider, and takes energy out of compression.
class Halved : public Law<Axisymmetric> {
 public:
  bool finite() const override { return true; }
  State start(const Vector<Axisymmetric>& stress, double void_ratio) const override {
    return {stress, void_ratio, Memory::Zero(1)};
  }
  void response(const State&, Response<Axisymmetric>&) const override {}
  FiniteStep<Axisymmetric> integrate(const State& from,
                                     const Vector<Axisymmetric>& strain) const override {
    FiniteStep<Axisymmetric> step;
    step.state = from;
    step.tangent << 30e6, 0, 0, -40e6;
    if (strain(1) < 0) step.failure = "too wide";
    step.state.stress += step.tangent * strain;
    return step;
  }
};

}  // namespace

TEST_CASE("Eq. 35 has its roots in zone (-, +, -) where sigma2 rises, and control ends there") {
  const auto material = law<Tensor>(Interpolation::octolinear, kOcto);
  for (const double eta : {0.68, 0.8}) {
    CAPTURE(eta);
    const IncrementalResponse<Tensor> response(material, plane_state(material, eta, 1.086));
    const auto roots = control_roots(response).roots;
    REQUIRE(roots.size() == 2);
    for (const ControlRoot& root : roots) {
      const auto zone = zone_of(stress_rate(response, root.angle).stress);
      CHECK(zone.loading == std::array{false, true, false});
    }
    // The moduli of (−, −, −) have none at 0.68, and at 0.8 others: 0.468 and 1.114.
    const auto form = std::get<InterpolatedForm<Tensor>>(response.response());
    const auto wrong = plane_compliance(principal_moduli(zone_compliance(form, ZoneSigns{})));
    for (const double R : control_quadratic(wrong).roots())
      for (const ControlRoot& root : roots) CHECK(std::abs(R - root.R) > 0.1);
    CHECK(control_quadratic(wrong).roots().size() == (eta < 0.7 ? 0 : 2));
    // Found without any direction: the control of every R tried in turn.
    const auto lost = lost_control(response, 0.05, 5).lost;
    REQUIRE(lost.size() == 1);
    CHECK(lost[0].from == Approx(roots[0].R).epsilon(1e-7));
    CHECK(lost[0].to == Approx(roots[1].R).epsilon(1e-7));
  }
}

TEST_CASE("of octolinear the roots are those of Eqs. 34 and 35 in closed form, in every zone") {
  const auto material = law<Tensor>(Interpolation::octolinear, kOcto);
  int roots = 0, across = 0;
  for (const double e : {0.85, 1.0, 1.086})
    for (double eta = 0.05; eta < 1.2; eta += 0.05)
      for (const double share : {0.0, 0.3, 0.8}) {  // of σ₂ between σ₃ and σ₁
        const double p = 70e3, q = eta * p, radial = p - q * (1 + share) / 3;
        const auto s = material.start(
            (Vector<Tensor>() << radial + q, radial + share * q, radial, 0, 0, 0).finished(), e);
        if (material.objection(s)) continue;
        const IncrementalResponse<Tensor> response(material, s);
        if (!answers_in_plane_strain(std::get<InterpolatedForm<Tensor>>(response.response())))
          continue;
        CAPTURE(e, eta, share);
        roots += check_closed_form(response);
        for (const ClosedForm& root : closed_form(zones_of(response)))
          across += root.zone.loading[1];
      }
  CHECK(roots > 50);
  CHECK(across > 20);
  const auto triaxial = octo();
  int of_axisymmetry = 0;
  for (const double eta : {-0.7, 0.3, 0.6, 0.9})
    of_axisymmetry += check_closed_form(*response_at(triaxial, 70, eta, 1.086));
  CHECK(of_axisymmetry >= 6);
}

TEST_CASE("of any law a root is a direction without second-order work, and obeys Eq. 40 there") {
  int roots = 0;
  for (const auto& [name, material] : stability_laws())
    for (const double eta : {0.3, 0.6, 0.75}) {
      CAPTURE(name, eta);
      const auto response = response_at(*material, 70, eta, 1.086);
      for (const ControlRoot& root : control_roots(*response).roots) {
        ++roots;
        CHECK(std::abs(root.normalised) < 1e-9);
        const auto rate = stress_rate(*response, root.angle);
        REQUIRE(rate.controllable);
        CHECK(std::abs(rate.normalised_work()) < 1e-9);
        const auto stress = axisymmetric_stress(rate.stress);
        CHECK(stress.radial / stress.axial == Approx(root.R).epsilon(1e-9));
        CHECK(rate.strain(0) / stress.radial == Approx(root.failure_rule).epsilon(1e-9));
        // The quadratic of the tangent of that very direction has it too.
        const auto tangent = plane_compliance(*response, rate);
        REQUIRE(tangent);
        CHECK(std::abs(control_determinant(*tangent, root.R)) < 1e-7);
        CHECK(failure_rule(*tangent, root.R) == Approx(root.failure_rule).epsilon(1e-5));
      }
    }
  CHECK(roots > 8);
}

TEST_CASE("a cone that ends where the law has no answer has no root there") {
  const Halved law;
  const IncrementalResponse<Axisymmetric> response(law, law.start({100e3, 100e3}, 0.8));
  // dε₃ > 0 takes dσ₃ < 0: W₂ = 0 at tan²α = 30/40 to either side of 180°, no answer for |α| < 90°.
  const auto [roots, unanswered] = control_roots(response);
  CHECK(unanswered > 30);
  REQUIRE(roots.size() == 2);
  for (const ControlRoot& root : roots)
    CHECK(std::tan(root.angle) * std::tan(root.angle) == Approx(0.75).epsilon(1e-5));
}
