// SPDX-License-Identifier: GPL-3.0-or-later
// The first unstable state three ways: by probing every direction, by the determinant, and by a
// paths that are integrated through it. A stress path follows the probed direction; a proportional
// strain path begins far away, at an isotropic state, and knows nothing of probes.
#include <catch2/catch.hpp>

#include "sim/point/path_runner.hpp"
#include "sim/stability/stability_determinant.hpp"
#include "sim/stability/strain_paths.hpp"
#include "tests/sim/stability/first_loss.hpp"
#include "tests/sim/stability/stability_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

constexpr double kAgreement = 1e-4;  // of η
const LossOptions kLine{.steps = 20, .precision = 1e-8};

Probe least(const Law<Axisymmetric>& law, double p_kPa, double eta, double e) {
  return probe_circle(stress_prober<Axisymmetric>(law, state_at(law, p_kPa, eta, e))).least;
}

std::optional<double> probed(const Law<Axisymmetric>& law, double p_kPa, double e) {
  return first_loss([&](double eta) { return std::optional(least(law, p_kPa, eta, e).normalised); },
                    0.05, 1.2, kLine);
}

double by_probing(const Law<Axisymmetric>& law, double p_kPa, double e) {
  const auto found = probed(law, p_kPa, e);
  REQUIRE(found);
  return *found;
}

std::optional<double> by_determinant(const Law<Axisymmetric>& law, double p_kPa, double e) {
  const auto determinant = [&](double eta) -> std::optional<double> {
    const auto d = stability_determinant(*response_at(law, p_kPa, eta, e));
    return d ? std::optional(d->value) : std::nullopt;
  };
  return first_loss(determinant, 0.05, 1.2, kLine);
}

/// Where W₂ vanishes on a straight stress path in this direction.
PathPoint<Axisymmetric> by_integration(const Law<Axisymmetric>& law,
                                       const PointState<Axisymmetric>& before, double angle) {
  Path<Axisymmetric> path;
  path.stress = before.stress;
  path.void_ratio = before.void_ratio;
  path.memory.assign(before.memory.data(), before.memory.data() + before.memory.size());
  Segment<Axisymmetric> segment;
  const double length = 0.6 * before.p();
  segment.conditions =
      MixedControl<Axisymmetric>::stresses({length * std::sin(angle), length * std::cos(angle)});
  segment.labels = {"axial_stress", "radial_stress"};
  path.segments = {segment};
  const auto result = run_path(law, path);
  for (const auto& event : result.events)
    if (event.kind == PathEventKind::second_order_work) return event.at;
  FAIL("no W₂ = 0 on the path: " + result.message);
  return {};
}

struct Where {
  double p_kPa, e;
};

}  // namespace

TEST_CASE("probing, determinant and path integration find the same first unstable state") {
  for (const auto& [name, law] : stability_laws())
    for (const auto& [p_kPa, e] : {Where{70, 1.086}, Where{300, 1.06}, Where{500, 1.136}}) {
      CAPTURE(name, p_kPa, e);
      const double eta = by_probing(*law, p_kPa, e);
      CHECK(by_determinant(*law, p_kPa, e).value() == Approx(eta).margin(kAgreement));

      const double angle = least(*law, p_kPa, eta, e).angle;
      const auto found = by_integration(*law, state_at(*law, p_kPa, eta - 0.002, e), angle);
      // It lies beyond the start, at its own p′ and e, where it is compared.
      CHECK(found.stress_ratio().value() > eta - 0.001);
      CHECK(found.stress_ratio().value() ==
            Approx(by_probing(*law, found.p() / 1e3, found.void_ratio)).margin(kAgreement));
    }
}

namespace {

/// Where W₂ vanishes on the path dε₁ + 2R dε₃ = 0 from 100 kPa, e = 1.086.
StrainPathPoint loss_on_strain_path(const Law<Axisymmetric>& law, double R) {
  const auto path = strain_path(law, law.isotropic(100e3, 1.086), R, {.axial_strain = 0.02});
  REQUIRE(path.first_unstable);
  return *path.first_unstable;
}

/// Direction of the failure mode dσ₁ = dσ₃/R, unloading.
double mode(double R) { return failure_angle(ProbePlane::axisymmetric, R) + std::numbers::pi; }

}  // namespace

TEST_CASE("a proportional strain path loses W2 where the probe of its mode does") {
  for (const auto& [name, law] : stability_laws())
    for (const double R : {0.8, 0.9, 1.0, 1.1}) {
      CAPTURE(name, R);
      const auto lost = loss_on_strain_path(*law, R);
      const auto work = [&, &unstable = *law](double eta) {  // clang 14 captures no part of a pair
        const auto state = state_at(unstable, lost.p / 1e3, eta, lost.void_ratio);
        return std::optional(stress_prober<Axisymmetric>(unstable, state)(mode(R)).normalised);
      };
      const auto probed_eta = first_loss(work, 0.3, 1.0, kLine);
      REQUIRE(probed_eta);
      CHECK(lost.q / lost.p == Approx(*probed_eta).margin(kAgreement));
    }
}

TEST_CASE("of all proportional strain paths the one with R* reaches the boundary of the domain") {
  for (const auto& [name, law] : stability_laws()) {
    CAPTURE(name);
    double low = 0.55, high = 1.5;  // the mode of R lies beyond the least direction, or before it
    for (int i = 0; i < 25; ++i) {
      const double R = (low + high) / 2;
      const auto lost = loss_on_strain_path(*law, R);
      const Probe least_work = least(*law, lost.p / 1e3, lost.q / lost.p, lost.void_ratio);
      (least_work.angle < mode(R) ? low : high) = R;
    }
    const auto lost = loss_on_strain_path(*law, low);
    CHECK(lost.q / lost.p ==
          Approx(by_probing(*law, lost.p / 1e3, lost.void_ratio)).margin(kAgreement));
    CHECK(lost.q / lost.p ==
          Approx(by_determinant(*law, lost.p / 1e3, lost.void_ratio).value()).margin(kAgreement));
  }
}

// In denser sand the first unstable direction of octolinear lowers η, so that no straight path in
// it leads through the boundary.
TEST_CASE("probing and determinant find the same first unstable state of denser sand") {
  int found = 0;
  for (const auto& [name, law] : stability_laws())
    for (const auto& [p_kPa, e] : {Where{70, 1.0}, Where{100, 0.95}, Where{100, 0.85}}) {
      CAPTURE(name, p_kPa, e);
      const auto eta = probed(*law, p_kPa, e), by_det = by_determinant(*law, p_kPa, e);
      REQUIRE(by_det.has_value() == eta.has_value());
      if (eta) CHECK(*by_det == Approx(*eta).margin(kAgreement));
      found += eta.has_value();
    }
  CHECK(found > 9);
}
