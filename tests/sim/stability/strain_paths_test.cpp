// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/strain_paths.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "sim/materials/elastic.hpp"
#include "sim/materials/mohr_coulomb.hpp"
#include "sim/point/path_runner.hpp"
#include "tests/sim/stability/stability_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

/// Where the path runner, which knows nothing of R, sees W₂ = 0.
std::optional<double> runner_sees(const Law<Axisymmetric>& law, double R, double axial_strain) {
  Path<Axisymmetric> path;
  const auto start = law.isotropic(100e3, 1.086);
  path.stress = start.stress;
  path.void_ratio = start.void_ratio;
  Segment<Axisymmetric> segment;
  segment.conditions = MixedControl<Axisymmetric>::strain_path(axial_strain, R);
  segment.labels = {"axial_strain", "R"};
  path.segments = {segment};
  for (const auto& event : run_path(law, path).events)
    if (event.kind == PathEventKind::second_order_work) return event.at.strain(0);
  return std::nullopt;
}

}  // namespace

TEST_CASE("the peak of the control stress is where W2 vanishes") {
  for (const auto& [name, law] : stability_laws())
    for (const double R : {0.7, 0.8, 0.9, 1.0}) {
      CAPTURE(name, R);
      const auto path = strain_path(*law, law->isotropic(100e3, 1.086), R, {.axial_strain = 0.02});
      const auto seen = runner_sees(*law, R, 0.02);
      REQUIRE(path.peak);
      REQUIRE(path.first_unstable);
      REQUIRE(seen);
      CHECK(path.peak->axial_strain == Approx(path.first_unstable->axial_strain).margin(1e-9));
      CHECK(path.first_unstable->axial_strain == Approx(*seen).margin(1e-8));
      CHECK(std::abs(path.peak->normalised_work.value()) < 1e-9);

      // It is a peak of what was integrated.
      for (const auto& p : path.points)
        if (p.axial_strain < 2 * path.peak->axial_strain)
          CHECK(p.control_stress <= path.peak->control_stress * (1 + 1e-12));
      CHECK(path.peak->control_stress > path.points.front().control_stress + 5e3);
    }
}

TEST_CASE("the points obey the path and the stresses their names") {
  const auto material = inl2();
  const auto path = strain_path(material, material.isotropic(100e3, 1.086), 0.8,
                                {.axial_strain = 0.01, .rows = 20});
  REQUIRE(path.points.size() == 21);
  CHECK(path.message.empty());
  CHECK(path.R == 0.8);
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const auto& p = path.points[i];
    CHECK(p.axial_strain == Approx(0.01 * static_cast<double>(i) / 20).margin(1e-12));
    // ln(1 + e) = ln(1 + e₀) − ε_v with ε_v = (1 − 1/R) ε₁.
    CHECK(std::log((1 + p.void_ratio) / 2.086) == Approx(0.25 * p.axial_strain).margin(1e-9));
    const double radial = p.p - p.q / 3;
    CHECK(p.control_stress == Approx(radial + p.q - radial / 0.8).margin(1e-6));
  }
  CHECK(path.points.front().normalised_work.value() > 0);
  CHECK(path.points.back().normalised_work.value() < 0);
}

TEST_CASE("elasticity and a contractant path of loose sand have no peak") {
  ElasticParameters parameters{.young_modulus_pa = 2e7, .poisson_ratio = 0.2};
  parameters.reference_pressure_pa = 1e5;
  const Elastic<Axisymmetric> elastic(parameters);
  const auto without = strain_path(elastic, elastic.isotropic(1e5, 0.8), 1, {.axial_strain = 0.01});
  CHECK_FALSE(without.peak);
  CHECK_FALSE(without.first_unstable);
  CHECK(without.message.empty());

  const auto material = inl2();
  CHECK_FALSE(strain_path(material, material.isotropic(100e3, 1.086), 2).first_unstable);
}

TEST_CASE("the plateau of perfect plasticity is no peak") {
  MohrCoulombParameters p;
  p.young_modulus_pa = 2e7;
  p.poisson_ratio = 0.2;
  p.reference_pressure_pa = 1e5;
  p.friction_angle = radians(32);
  const MohrCoulomb<Axisymmetric> material(p);
  const auto isochoric = strain_path(material, material.isotropic(1e5, 0.8), 1);
  CHECK(isochoric.points.back().q == Approx(stress_ratio_at_friction_angle(radians(32)) * 1e5));
  CHECK_FALSE(isochoric.peak);
  CHECK_FALSE(isochoric.first_unstable);
  // Dilatant: the pressure falls, and the control stress with it from yield on.
  CHECK(strain_path(material, material.isotropic(1e5, 0.8), 0.8).peak);
}

TEST_CASE("the hump of a stress that vanishes is no peak: the least R with a peak") {
  const auto material = inl2();
  const auto start = material.isotropic(100e3, 1.086);
  const auto at = [&](double R, double least_p) {
    return strain_path(material, start, R, {.axial_strain = 0.02, .least_p = least_p});
  };
  // Without the bound a hump inside the fade below 2 kPa is found.
  const auto hump = at(0.52, 0).peak;
  REQUIRE(hump);
  CHECK(hump->p < 2e3);
  const auto judged = at(0.52, 2e3);
  CHECK_FALSE(judged.peak);
  CHECK_FALSE(judged.first_unstable);
  REQUIRE(judged.vanished);
  CHECK(judged.vanished->p == Approx(2e3).epsilon(1e-6));

  double without = 0.5, with = 0.7;
  while (with - without > 1e-3) {
    const double middle = (with + without) / 2;
    (at(middle, 2e3).peak ? with : without) = middle;
  }
  CHECK(with > 0.575);
  CHECK(with < 0.605);
  CHECK(at(with, 2e3).peak->p >= 2e3);

  const auto from_below =
      strain_path(material, material.isotropic(1.9e3, 1.086), 1, {.axial_strain = 1e-3});
  CHECK_FALSE(from_below.peak);
  REQUIRE(from_below.vanished);
  CHECK(from_below.vanished->axial_strain == 0);
}

TEST_CASE("a path that starts unstable says so at its start") {
  const auto material = inl2();
  const auto path =
      strain_path(material, state_at(material, 70, 0.7, 1.086), 1, {.axial_strain = 1e-3});
  REQUIRE(path.first_unstable);
  CHECK(path.first_unstable->axial_strain == 0);
  CHECK_FALSE(path.peak);
}

TEST_CASE("where the path ends early, the last point and a message tell") {
  const auto material = inl2();
  const auto path = strain_path(material, material.isotropic(100e3, 1.086), 0.7);
  CHECK_FALSE(path.message.empty());
  CHECK(path.points.back().axial_strain < 0.05);
  CHECK(path.points.back().axial_strain > path.points[path.points.size() - 2].axial_strain);
  CHECK(path.peak);
}

TEST_CASE("numbers that make no path are refused") {
  const auto material = inl2();
  const auto start = material.isotropic(100e3, 1.086);
  CHECK_THROWS_AS(strain_path(material, start, 0), std::invalid_argument);
  CHECK_THROWS_AS(strain_path(material, start, 1, {.axial_strain = -0.01}), std::invalid_argument);
  CHECK_THROWS_AS(strain_path(material, start, 1, {.rows = 0}), std::invalid_argument);
}
