// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/paths/grain_path.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "tests/sim/grains/packings.hpp"
#include "tests/sim/grains/specimens.hpp"

using namespace triax::sim;

namespace {

GrainPath strain_path(double ratio, double strain) {
  GrainPath path;
  path.kind = GrainPathKind::strain_path;
  path.ratio = ratio;
  path.strain_rate_per_s = 1;
  path.axial_strain = strain;
  path.samples = 20;
  return path;
}

}  // namespace

TEST_CASE("Grain path: undrained loading keeps the volume to round-off") {
  const GrainState& start = test::dense_specimen().state;
  const GrainPathResult r = follow(start, strain_path(1, 0.01));
  REQUIRE(r.end == GrainPathEnd::axial_strain);
  CHECK(r.state.box.volume_m3() == Approx(start.box.volume_m3()).epsilon(1e-12));
  CHECK(r.points.back().strain.axial == Approx(0.01).epsilon(0.01));
  CHECK(r.points.back().q_pa > 2e4);
  CHECK(r.points.size() >= 20);
  CHECK(r.points.size() <= 22);
}

TEST_CASE("Grain path: a strain path keeps its ratio of strains") {
  const double ratio = 0.7;
  const GrainPathResult r = follow(test::dense_specimen().state, strain_path(ratio, 0.005));
  for (const GrainPathPoint& p : r.points) {
    CHECK(p.strain.axial + 2 * ratio * p.strain.radial == Approx(0).margin(1e-12));
    CHECK(p.path_stress_pa == Approx(p.stress.axial - p.stress.radial / ratio));
    CHECK(p.q_pa == Approx(p.stress.axial - p.stress.radial));
    CHECK(p.volumetric_strain == Approx(p.strain.axial + 2 * p.strain.radial));
  }
}

TEST_CASE("Grain path: drained compression holds the lateral stress and ends at its ratio") {
  GrainPath path;
  path.pressure_pa = 1e5;
  path.strain_rate_per_s = 0.3;
  path.axial_strain = 0.05;
  path.stress_ratio = 0.6;
  path.marks = {{PathMark::Quantity::stress_ratio, 0.4, false},
                {PathMark::Quantity::axial_strain, 0.04, false}};
  const GrainPathResult r = follow(test::dense_specimen().state, path);
  REQUIRE(r.end == GrainPathEnd::stress_ratio);
  CHECK(r.points.back().stress_ratio() == Approx(0.6).epsilon(0.03));
  for (const GrainPathPoint& p : r.points) CHECK(p.stress.radial == Approx(1e5).epsilon(0.05));
  REQUIRE(r.marked[0]);
  CHECK_FALSE(r.marked[1]);
  CHECK(path_point(*r.marked[0], test::dense_specimen().state.box, 1).stress_ratio() ==
        Approx(0.4).epsilon(0.05));
  CHECK(test::same_bits(r.state, follow(test::dense_specimen().state, path, 2).state));
}

TEST_CASE("Grain path: isotropic loading comes to rest at its pressure") {
  GrainPath path;
  path.kind = GrainPathKind::isotropic;
  path.pressure_pa = 2e5;
  path.samples = 8;
  const GrainPathResult r = follow(test::dense_specimen().state, path);
  REQUIRE(r.end == GrainPathEnd::at_rest);
  const GrainPathPoint& end = r.points.back();
  CHECK(end.stress.axial == Approx(2e5).epsilon(1e-3));
  CHECK(end.stress.radial == Approx(2e5).epsilon(1e-3));
  CHECK(end.unbalanced < 1e-4);
  CHECK(end.porosity < r.points.front().porosity);
  CHECK(r.points.size() <= 10);
}

TEST_CASE("Grain path: a mark from above waits until the quantity was above") {
  GrainPath path;
  path.strain_rate_per_s = 0.3;
  path.axial_strain = 0.05;
  path.stress_ratio = 0.3;
  path.marks = {{PathMark::Quantity::stress_ratio, 0.5, true}};
  CHECK_FALSE(follow(test::dense_specimen().state, path).marked[0]);

  path.strain_rate_per_s = -0.3;
  path.axial_strain = 0.005;
  path.stress_ratio.reset();
  const GrainPathResult falls = follow(test::calm_state(), path);
  REQUIRE(falls.points.front().stress_ratio() > 0.7);
  REQUIRE(falls.marked[0]);
  CHECK(path_point(*falls.marked[0], test::calm_state().box, 1).stress_ratio() ==
        Approx(0.5).margin(0.05));
}

TEST_CASE("Grain path: an expanding specimen collapses") {
  const GrainPathResult r = follow(test::loose_specimen().state, strain_path(0.3, 0.05));
  CHECK(r.end == GrainPathEnd::collapse);
  CHECK(r.points.back().p_pa < 0.02 * r.points.front().p_pa);
}

TEST_CASE("Grain path: progress stops it, and bad settings are refused") {
  GrainPath path = strain_path(1, 0.01);
  const auto no = [](double, const std::string&) { return false; };
  CHECK(follow(test::dense_specimen().state, path, 1, no).end == GrainPathEnd::stopped);
  path.ratio = 0;
  CHECK_THROWS_AS(follow(test::dense_specimen().state, path), std::invalid_argument);
  path.ratio = 1;
  path.strain_rate_per_s = 0;
  CHECK_THROWS_AS(follow(test::dense_specimen().state, path), std::invalid_argument);
}

TEST_CASE("Grain path: by load the conjugate stress rises at its rate, volume kept") {
  GrainPath path = strain_path(1, 0.02);
  path.load_rate_pa_per_s = 2e6;
  path.stress_ratio = 0.4;
  const GrainState& start = test::dense_specimen().state;
  const GrainPathResult r = follow(start, path);
  REQUIRE(r.end == GrainPathEnd::stress_ratio);
  CHECK(r.state.box.volume_m3() == Approx(start.box.volume_m3()).epsilon(1e-12));
  const GrainPathPoint& end = r.points.back();
  CHECK(end.path_stress_pa == Approx(2e6 * end.time_s).epsilon(0.05));
  CHECK(r.points.size() <= 22);
  path.kind = GrainPathKind::drained;
  path.pressure_pa = 1e5;
  path.load_rate_pa_per_s = -2e6;
  path.stress_ratio = -0.2;
  const GrainPathResult extension = follow(start, path);
  REQUIRE(extension.end == GrainPathEnd::stress_ratio);
  CHECK(extension.points.back().stress.axial ==
        Approx(1e5 - 2e6 * extension.points.back().time_s).epsilon(0.05));
  path.load_rate_pa_per_s = std::nan("");
  CHECK_THROWS_AS(follow(start, path), std::invalid_argument);
}

TEST_CASE("Grain path: under load a loose specimen runs away beyond its peak") {
  GrainPath path = strain_path(0.9, 0.03);
  path.samples = 200;
  path.strain_rate_per_s = 0.2;
  const auto most = [](const GrainPathResult& r) {
    double peak = 0;
    for (const GrainPathPoint& p : r.points) peak = std::max(peak, p.path_stress_pa);
    return peak;
  };
  const GrainPathResult by_strain = follow(test::loose_specimen().state, path);
  const double peak = most(by_strain);
  REQUIRE(by_strain.points.back().path_stress_pa < 0.5 * peak);
  path.load_rate_pa_per_s = 2e5;
  const GrainPathResult by_load = follow(test::loose_specimen().state, path);
  CHECK(most(by_load) > 0.8 * peak);
  // The load still rises; what it was to be at the end is far above what is carried.
  const GrainPathPoint& end = by_load.points.back();
  const double start = by_load.points.front().path_stress_pa;
  CHECK(start + 2e5 * end.time_s > 2 * end.path_stress_pa);
  const GrainPathPoint& before = by_load.points[by_load.points.size() - 2];
  CHECK((end.strain.axial - before.strain.axial) / (end.time_s - before.time_s) > 1);
}
