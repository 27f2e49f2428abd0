// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/measured_path.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <stdexcept>

using namespace triax::study;

namespace {

/// A drained hyperbola with contraction, at these strains.
std::vector<ShearReading> hyperbola(const std::vector<double>& strains) {
  std::vector<ShearReading> readings;
  for (const double s : strains) {
    const double q = 200e3 * s / (0.01 + s);
    readings.push_back({s, 0.01 * (1 - std::exp(-s / 0.02)), 100e3 + q / 3, q});
  }
  return readings;
}

std::vector<double> even(int count, double last) {
  std::vector<double> strains;
  for (int i = 1; i <= count; ++i) strains.push_back(last * i / count);
  return strains;
}

MeasuredPath drained() {
  MeasuredPath path{.imposed = Imposed::drained, .void_ratio = 0.9};
  path.start.p_eff = 100e3;
  return path;
}

/// Share of the weight below a strain.
double weight_below(const MeasuredPath& path, double strain) {
  double sum = 0;
  for (const auto& knot : path.knots)
    if (knot.axial_strain <= strain) sum += knot.weight;
  return sum;
}

}  // namespace

TEST_CASE("weights follow the arc length of the path, however dense its readings are") {
  MeasuredPath sparse = drained(), dense = drained();
  lay_knots(sparse, hyperbola(even(400, 0.1)));
  auto strains = even(400, 0.1);
  for (const double s : even(4000, 0.02)) strains.push_back(s);
  std::ranges::sort(strains);
  lay_knots(dense, hyperbola(strains));
  for (const MeasuredPath* path : {&sparse, &dense}) {
    double sum = 0;
    for (const auto& knot : path->knots) sum += knot.weight;
    CHECK(sum == Approx(1));
  }
  for (const double s : {0.01, 0.02, 0.05})
    CHECK(weight_below(dense, s) == Approx(weight_below(sparse, s)).margin(0.06));
}

TEST_CASE("knots are readings, the noise is that of single values, and it widens the scale") {
  std::mt19937_64 dice(3);
  std::normal_distribution<double> noise(0, 1e3);
  auto readings = hyperbola(even(2000, 0.1));
  for (auto& r : readings) r.q += noise(dice);
  MeasuredPath path = drained();
  lay_knots(path, readings);
  CHECK(path.noise[0] == Approx(1e3).epsilon(0.1));
  CHECK(path.noise[1] < 1e-6);
  CHECK(path.scale[0] == Approx(std::hypot(path.noise[0], kAccuracy * path.span[0])));
  for (const auto& knot : path.knots)
    CHECK(std::ranges::any_of(readings, [&](const ShearReading& r) {
      return r.axial_strain == knot.axial_strain && r.q == knot.q;
    }));
}

TEST_CASE("a strain that only its noise brings back is left out, an unloading is not") {
  auto strains = even(200, 0.05);
  for (std::size_t i = 10; i < strains.size(); i += 10) strains[i] = strains[i - 1] - 1e-9;
  MeasuredPath path = drained();
  lay_knots(path, hyperbola(strains));
  for (std::size_t k = 1; k < path.knots.size(); ++k)
    CHECK(path.knots[k].axial_strain > path.knots[k - 1].axial_strain);

  strains = even(200, 0.05);
  for (int i = 1; i <= 50; ++i) strains.push_back(0.05 - 0.0002 * i);
  MeasuredPath unloaded = drained();
  lay_knots(unloaded, hyperbola(strains));
  CHECK(unloaded.knots.back().axial_strain == Approx(0.04));
}

TEST_CASE("a path ends where p' has all but vanished, and one of few readings is refused") {
  auto readings = hyperbola(even(100, 0.1));
  for (auto& r : readings) r.p_eff = 100e3 * (1 - 10.05 * r.axial_strain);
  MeasuredPath path = drained();
  lay_knots(path, readings);
  CHECK(path.knots.back().p_eff >= 1e3);
  MeasuredPath few = drained();
  CHECK_THROWS_AS(lay_knots(few, hyperbola(even(4, 0.1))), std::invalid_argument);
}
