// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/specimens/cloud.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "sim/grains/state/random.hpp"

namespace triax::sim {
namespace {

constexpr double kMostSolid = 0.45;
constexpr int kMostTries = 200000;

/// Spheres by cell; a cell is as wide as the largest sphere, so that overlaps lie in the 27 cells
/// around.
class Places {
 public:
  Places(double length, double widest)
      : count_(std::clamp(static_cast<int>(length / widest), 1, 512)),
        per_m_(count_ / length),
        cells_(static_cast<std::size_t>(count_) * count_ * count_) {}

  bool free(const Sphere& s) const {
    std::array<int, 3> low{}, high{};
    for (int a = 0; a < 3; ++a) {
      const int at = along(s.centre_m[a]);
      low[a] = std::max(at - 1, 0);
      high[a] = std::min(at + 1, count_ - 1);
    }
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int z = low[2]; z <= high[2]; ++z)
          for (const Sphere& other : cells_[index(x, y, z)])
            if (overlap(s, other)) return false;
    return true;
  }

  void put(const Sphere& s) {
    cells_[index(along(s.centre_m[0]), along(s.centre_m[1]), along(s.centre_m[2]))].push_back(s);
  }

 private:
  int along(double x) const { return std::min(static_cast<int>(x * per_m_), count_ - 1); }
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(x) * count_ + y) * count_ + z;
  }
  static bool overlap(const Sphere& a, const Sphere& b) {
    const double x = a.centre_m[0] - b.centre_m[0], y = a.centre_m[1] - b.centre_m[1],
                 z = a.centre_m[2] - b.centre_m[2], reach = a.radius_m + b.radius_m;
    return x * x + y * y + z * z < reach * reach;
  }

  int count_;
  double per_m_;
  std::vector<std::vector<Sphere>> cells_;
};

double solid_volume(const std::vector<double>& diameters) {
  double volume = 0;
  for (const double d : diameters) {
    if (!(d > 0 && std::isfinite(d)))
      throw std::invalid_argument("cloud: a diameter must be above 0");
    volume += std::numbers::pi / 6 * d * d * d;
  }
  return volume;
}

Sphere placed(double radius, double length, const Places& places, Random& random) {
  Sphere s;
  s.radius_m = radius;
  for (int tries = 0; tries < kMostTries; ++tries) {
    for (double& x : s.centre_m) x = random.uniform(radius, length - radius);
    if (places.free(s)) return s;
  }
  throw std::invalid_argument(
      "cloud: no place is left for a grain; choose a smaller solid fraction");
}

}  // namespace

Cloud make_cloud(const std::vector<double>& diameters_m, std::uint64_t seed, double solid_share) {
  if (diameters_m.empty()) throw std::invalid_argument("cloud: at least one grain is needed");
  if (!(solid_share > 0 && solid_share <= kMostSolid))
    throw std::invalid_argument("cloud: the solid fraction must be above 0 and at most 0.45");
  const double length = std::cbrt(solid_volume(diameters_m) / solid_share);
  const double widest = *std::max_element(diameters_m.begin(), diameters_m.end());

  std::vector<std::size_t> order(diameters_m.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return diameters_m[a] > diameters_m[b]; });
  Cloud cloud;
  cloud.spheres.resize(diameters_m.size());
  cloud.box.high_m = {length, length, length};
  Places places(length, widest);
  Random random(seed);
  for (const std::size_t i : order) {
    cloud.spheres[i] = placed(0.5 * diameters_m[i], length, places, random);
    places.put(cloud.spheres[i]);
  }
  return cloud;
}

}  // namespace triax::sim
