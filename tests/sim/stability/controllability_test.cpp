// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/controllability.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "sim/stability/octolinear_cones.hpp"
#include "tests/sim/stability/first_loss.hpp"
#include "tests/sim/stability/stability_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

/// The R whose mode a direction is.
double ratio_of(ProbePlane plane, double angle) {
  const double weight = plane == ProbePlane::axisymmetric ? std::numbers::sqrt2 : 1;
  return std::cos(angle) / (std::sin(angle) * weight);
}

const ControlIndex& named(const std::vector<ControlIndex>& all, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const ControlIndex& c) { return c.name == name; });
  REQUIRE(found != all.end());
  return *found;
}

/// First η at p′ = 70 kPa, e = 1.086 at which a named control is lost.
double lost_at(const Law<Axisymmetric>& law, const std::string& name) {
  return first_loss(
             [&](double eta) {
               const auto all =
                   control_indices(*response_at(law, 70, eta, 1.086), triaxial_controls());
               return named(all, name).answer.held() ? 1.0 : -1.0;
             },
             0.1, 1, {.steps = 18})
      .value_or(0);
}

/// Elasticity that integrates itself and has no answer where the specimen gets wider.
class OneSided : public Law<Axisymmetric> {
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
    step.tangent << 30e6, 10e6, 10e6, 40e6;
    if (strain(1) < 0) step.failure = "too wide";
    step.state.stress += step.tangent * strain;
    return step;
  }
};

}  // namespace

TEST_CASE("octolinear loses control at the roots of Eq. 34 in the zone that holds the mode") {
  const auto material = octo();
  for (const double eta : {0.56, 0.6, 0.7, 0.8}) {
    const auto response = *response_at(material, 70, eta, 1.086);
    const auto zones = octolinear_zones(moduli(material, state_at(material, 70, eta, 1.086)));
    std::vector<double> expected;
    for (const auto& cone : unstable_sectors(zones))
      for (const double edge : {cone.from, cone.to})
        expected.push_back(ratio_of(ProbePlane::axisymmetric, edge));
    std::sort(expected.begin(), expected.end());
    REQUIRE(expected.size() == 2);
    const auto lost = lost_control(response, 0.05, 3).lost;
    REQUIRE(lost.size() == 1);
    CHECK(lost[0].begins);
    CHECK(lost[0].ends);
    CHECK(lost[0].from == Approx(expected[0]).epsilon(1e-10));
    CHECK(lost[0].to == Approx(expected[1]).epsilon(1e-10));
    // The control itself says so on either side.
    for (const double inside : {expected[0] * (1 + 1e-5), expected[1] * (1 - 1e-5)})
      CHECK_FALSE(scan_control(response, {inside})[0].controllable);
    for (const double outside : {expected[0] * (1 - 1e-5), expected[1] * (1 + 1e-5)})
      CHECK(scan_control(response, {outside})[0].controllable);
  }
  CHECK(lost_control(*response_at(material, 70, 0.4, 1.086), 0.05, 3).lost.empty());
}

TEST_CASE("any law loses control at the edges of its cone, the roots of Eq. 34 of that tangent") {
  for (const auto& [name, law] : stability_laws()) {
    INFO(name);
    const auto state = state_at(*law, 70, 0.62, 1.086);
    const IncrementalResponse<Axisymmetric> response(*law, state);
    const auto circle = probe_circle(stress_prober<Axisymmetric>(*law, state));
    REQUIRE(circle.cones.size() == 1);
    const auto& cone = circle.cones[0];
    const auto lost = lost_control(response, 0.05, 5).lost;
    REQUIRE(lost.size() == 1);
    // R grows as α turns towards 180 degrees.
    CHECK(lost[0].to == Approx(ratio_of(ProbePlane::axisymmetric, cone.from)).epsilon(1e-6));
    CHECK(lost[0].from == Approx(ratio_of(ProbePlane::axisymmetric, cone.to)).epsilon(1e-6));
    for (const double edge : {cone.from, cone.to}) {
      const auto tangent =
          plane_compliance(response, response.to_stress({std::sin(edge), std::cos(edge)}));
      REQUIRE(tangent);
      const double R = ratio_of(ProbePlane::axisymmetric, edge);
      CHECK(std::abs(control_determinant(*tangent, R)) < 1e-7);
      // The mode obeys the failure rule.
      const auto point = scan_control(response, {R})[0];
      const double rule = failure_rule(*tangent, R);
      CHECK(point.mode.strain.y() ==
            Approx(rule * point.mode.stress.x() / std::numbers::sqrt2).epsilon(1e-6));
    }
  }
}

TEST_CASE("a scan tells what can be controlled, how far from loss, and the mode") {
  const auto material = inl2();
  const auto response = *response_at(material, 70, 0.62, 1.086);
  const auto scan = scan_control(response, {0.1, 0.5, 1.0, 2.0});
  REQUIRE(scan.size() == 4);
  for (const ControlPoint& point : scan) {
    CAPTURE(point.R);
    CHECK(point.controllable == (point.mode.normalised > 0));
    CHECK(point.unloading.held());
    CHECK(point.controllable == point.loading.held());
    CHECK(point.controllable == point.index.has_value());
    CHECK(point.controllable == point.loading.probe.answered);
    CHECK(std::remainder(point.mode.angle - failure_angle(ProbePlane::axisymmetric, point.R),
                         std::numbers::pi) == Approx(0).margin(1e-12));
    if (point.controllable) {
      CHECK(*point.index > 0);
      const auto& a = point.loading.probe;
      CHECK(a.strain.y() + std::numbers::sqrt2 * point.R * a.strain.x() ==
            Approx(0).margin(1e-10 * a.strain.norm()));
      CHECK(a.stress.y() > a.stress.x() / (std::numbers::sqrt2 * point.R));
      CHECK(a.stress.norm() == Approx(1));
    }
  }
  CHECK(scan[0].controllable);
  CHECK_FALSE(scan[2].controllable);
}

TEST_CASE("plane strain: octolinear loses control at the roots of Eq. 35") {
  const auto material = law<Tensor>(Interpolation::octolinear, kOcto);
  const auto state = material.start(as_tensor(state_at(octo(), 70, 0.8, 1.086).stress), 1.086);
  const auto zones = octolinear_zones(std::get<InterpolatedForm<Tensor>>(material.response(state)));
  std::vector<double> expected;
  for (const auto& cone : unstable_sectors(zones))
    for (const double edge : {cone.from, cone.to})
      expected.push_back(ratio_of(ProbePlane::plane_strain, edge));
  std::sort(expected.begin(), expected.end());
  REQUIRE(expected.size() == 2);
  const auto lost = lost_control(IncrementalResponse<Tensor>(material, state), 0.05, 5).lost;
  REQUIRE(lost.size() == 1);
  CHECK(lost[0].from == Approx(expected[0]).epsilon(1e-10));
  CHECK(lost[0].to == Approx(expected[1]).epsilon(1e-10));
}

TEST_CASE(
    "undrained loading and constant q by volume are lost where isotropic unloading has no W2") {
  for (const auto& [name, law] : stability_laws()) {
    INFO(name);
    const auto work = [&law = law](double eta) {
      return std::optional(
          stress_prober<Axisymmetric>(*law, state_at(*law, 70, eta, 1.086))(kIsotropicUnloading)
              .second_order_work);
    };
    const double eta = first_loss(work, 0.1, 1, {.steps = 18}).value_or(0);
    CHECK(eta > 0.5);
    CHECK(lost_at(*law, "undrained, dq > 0") == Approx(eta).margin(1e-6));
    CHECK(lost_at(*law, "dq = 0, dεv < 0") == Approx(eta).margin(1e-6));
    // Under displacement, or stress alone, the state goes on.
    const auto beyond =
        control_indices(*response_at(*law, 70, eta + 0.01, 1.086), triaxial_controls());
    CHECK(named(beyond, "undrained, dε1 > 0").answer.held());
    CHECK(named(beyond, "dq = 0, dp′ < 0").answer.held());
    CHECK(named(beyond, "drained, dσ1 > 0, dσ3 = 0").answer.held());
    CHECK(named(beyond, "drained, dε1 > 0, dσ3 = 0").answer.held());
    CHECK(named(beyond, "all strains, dε1 > 0, dε3 = 0").answer.index > 0);
  }
}

TEST_CASE("in extension control is lost where sigma1 - sigma3/R falls, at the edges of the cone") {
  int looked_at = 0;
  for (const auto& [name, law] : stability_laws()) {
    INFO(name);
    const auto state = state_at(*law, 70, -0.65, 1.086);
    const auto circle = probe_circle(stress_prober<Axisymmetric>(*law, state));
    if (circle.unanswered > 0) continue;  // beyond the limit of the law: no edge of a cone
    REQUIRE(circle.cones.size() == 1);
    ++looked_at;
    const auto& cone = circle.cones[0];
    const auto lost =
        lost_control(IncrementalResponse<Axisymmetric>(*law, state), 0.05, 20, 800).lost;
    REQUIRE(lost.size() == 1);
    CHECK(lost[0].sense == ControlSense::unloading);
    CHECK(lost[0].from == Approx(ratio_of(ProbePlane::axisymmetric, cone.to)).epsilon(1e-6));
    CHECK(lost[0].to == Approx(ratio_of(ProbePlane::axisymmetric, cone.from)).epsilon(1e-6));
    const double inside = (lost[0].from + lost[0].to) / 2;
    const auto point = scan_control(IncrementalResponse<Axisymmetric>(*law, state), {inside})[0];
    CHECK(point.loading.held());
    CHECK(point.unloading.state == ControlState::lost);
    CHECK_FALSE(point.controllable);
    CHECK_FALSE(point.unloading.index);
    CHECK_FALSE(point.index);
    CHECK(point.unloading.limiting_variable >= 0);
  }
  CHECK(looked_at >= 3);
}

TEST_CASE("in compression it is lost where sigma1 - sigma3/R grows; the index is nowhere noise") {
  const auto material = sanisand();
  const auto response = *response_at(material, 70, 0.62, 1.086);
  const auto search = lost_control(response, 0.05, 5, 100);
  REQUIRE(search.lost.size() == 1);
  CHECK(search.lost[0].sense == ControlSense::loading);
  CHECK(search.asked == 202);
  CHECK(search.unanswered == 0);
  const double middle = (search.lost[0].from + search.lost[0].to) / 2;
  const auto point = scan_control(response, {middle})[0];
  CHECK_FALSE(point.loading.index);
  REQUIRE(point.unloading.index);
  // The determinant of Eq. (32) with the tangent of the mode is that of its second-order work.
  REQUIRE(point.matrix);
  CHECK(point.matrix->determinant < 0);
  CHECK(point.matrix->entries.determinant() == Approx(point.matrix->determinant).epsilon(1e-9));
}

TEST_CASE("a law that fails in some directions has lost no control there") {
  const OneSided law;
  const IncrementalResponse<Axisymmetric> response(law, law.start({100e3, 100e3}, 0.8));
  const auto search = lost_control(response, 0.05, 5, 100);
  CHECK(search.lost.empty());
  CHECK(search.unanswered > 50);
  CHECK(search.unanswered < search.asked);
  const auto point = scan_control(response, {1})[0];
  CHECK(point.loading.state == ControlState::unanswered);
  CHECK(point.unloading.held());
  CHECK_FALSE(point.controllable);
  CHECK_FALSE(point.index);
}
