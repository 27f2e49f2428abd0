// SPDX-License-Identifier: GPL-3.0-or-later
// bench_cpp_loop POINTS ROUNDS: one increment of SANISAND at each of many points, as a host program
// in C++ writes the loop: a struct a point, advance_point, the state put back. Prints a line a
// round: nanoseconds of processor time a point, and the sum of all stresses afterwards.
// bench/python/increments.py does the same from Python.
#include <array>
#include <cstdlib>
#include <vector>

#include "bench/point/yardstick.hpp"
#include "lab/materials/material_library.hpp"
#include "sim/point/point_driver.hpp"

using namespace triax;
using Space = sim::Axisymmetric;

namespace {

constexpr int kShearing = 100;         // increments that make the state all points start from
constexpr double kShearStrain = 0.02;  // axial, undrained
constexpr double kStrain = 2e-5;       // axial, of the increment that is timed
constexpr double kTolerance = 1e-6;

struct Point {
  sim::Vector<Space> stress;
  double void_ratio;
  std::array<double, 6> memory;
};

Point kept(const sim::PointState<Space>& state) {
  Point point{state.stress, state.void_ratio, {}};
  std::copy_n(state.memory.data(), point.memory.size(), point.memory.begin());
  return point;
}

sim::PointState<Space> state_of(const Point& p) {
  return {p.stress, p.void_ratio, Eigen::Map<const Eigen::Vector<double, 6>>(p.memory.data())};
}

std::vector<Point> sheared(const sim::Law<Space>& law, std::size_t count) {
  const sim::PointTolerance tolerance{.relative = kTolerance};
  auto state = law.isotropic(100e3, 0.8);
  for (int i = 0; i < kShearing; ++i)
    state =
        sim::advance_point(
            law, state, sim::MixedControl<Space>::strain_path(kShearStrain / kShearing), tolerance)
            .state;
  std::vector<Point> points(count, kept(state));
  for (std::size_t i = 0; i < count; ++i)
    points[i].void_ratio += 1e-5 * static_cast<double>(i % 1000);
  return points;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: bench_cpp_loop POINTS ROUNDS\n");
    return 2;
  }
  const auto count = static_cast<std::size_t>(std::atoll(argv[1]));
  const auto set = lab::find_material("sanisand/S28-general");
  const auto& law = *set.material.axisymmetric;
  const auto control = sim::MixedControl<Space>::strains(
      sim::components(sim::AxisymmetricStrain{kStrain, -kStrain / 2}));
  const sim::PointTolerance tolerance{.relative = kTolerance};
  const auto start = sheared(law, count);
  for (int round = std::atoi(argv[2]); round > 0; --round) {
    auto points = start;
    const double seconds = bench::least_thread_seconds(1, [&] {
      for (Point& point : points)
        point = kept(sim::advance_point(law, state_of(point), control, tolerance).state);
    });
    double sum = 0;
    for (const Point& point : points)
      sum += (point.stress(0) + point.stress(1) / std::numbers::sqrt2) / 1e3;
    fmt::print("{:.1f} {:.9g}\n", seconds * 1e9 / static_cast<double>(count), sum);
  }
}
