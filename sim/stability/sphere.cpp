#include "sim/stability/sphere.hpp"

#include <algorithm>
#include <random>
#include <stdexcept>
#include <utility>

#include "sim/stability/cones.hpp"

namespace triax::sim {
namespace {

constexpr double kPi = std::numbers::pi;
/// Steps below which a descent ends, rad: the minimum's value is then exact to round-off.
constexpr double kFinest = 1e-8;

bool is_unstable(const SphereProbe& p) { return p.answered && p.normalised < kUnstable; }

/// Descends from a unit vector by trying steps along every axis, halved where none leads down.
/// `work` gives the value at a unit vector, infinity where there is none.
template <class V, class Work>
std::pair<V, double> descend(V at, double step, const Work& work) {
  double least = work(at);
  while (step > kFinest) {
    bool moved = false;
    for (Eigen::Index axis = 0; axis < at.size(); ++axis)
      for (const double sign : {1.0, -1.0}) {
        V next = at;
        next(axis) += sign * step;
        next.normalize();
        const double value = work(next);
        if (!(value < least)) continue;
        least = value;
        at = next;
        moved = true;
      }
    if (!moved) step /= 2;
  }
  return {at, least};
}

double value(bool answered, double normalised) {
  return answered ? normalised : std::numeric_limits<double>::infinity();
}

PointRate<Tensor> answer(const IncrementalResponse<Tensor>& response, ProbeKind kind,
                         const Vector<Tensor>& direction) {
  return kind == ProbeKind::stress ? response.to_stress(direction) : response.to_strain(direction);
}

/// Connected regions of unstable cells: cells are neighbours along both angles, the azimuth is
/// periodic, and the cells of the first and of the last ring meet in a pole.
int regions(const Sphere& sphere) {
  const int n = sphere.sectors;
  std::vector<bool> seen(sphere.probes.size(), false);
  const auto open = [&](int cell) {
    const auto i = static_cast<std::size_t>(cell);
    return is_unstable(sphere.probes[i]) && !seen[i];
  };
  int count = 0;
  for (int first = 0; first < sphere.rings * n; ++first) {
    if (!open(first)) continue;
    ++count;
    std::vector<int> waiting{first};
    const auto reach = [&](int cell) {
      if (!open(cell)) return;
      seen[static_cast<std::size_t>(cell)] = true;
      waiting.push_back(cell);
    };
    seen[static_cast<std::size_t>(first)] = true;
    while (!waiting.empty()) {
      const int cell = waiting.back(), ring = cell / n, sector = cell % n;
      waiting.pop_back();
      reach(ring * n + (sector + 1) % n);
      reach(ring * n + (sector + n - 1) % n);
      if (ring > 0) reach(cell - n);
      if (ring + 1 < sphere.rings) reach(cell + n);
      if (ring == 0 || ring + 1 == sphere.rings) reach(ring * n + (sector + n / 2) % n);
    }
  }
  return count;
}

}  // namespace

Eigen::Vector3d sphere_direction(double polar, double azimuth) {
  static const Eigen::Vector3d kAxis = Eigen::Vector3d(1, 1, 1) / std::sqrt(3.0);
  static const Eigen::Vector3d kFirst = Eigen::Vector3d(2, -1, -1) / std::sqrt(6.0);
  static const Eigen::Vector3d kSecond = Eigen::Vector3d(0, 1, -1) / std::sqrt(2.0);
  return std::cos(polar) * kAxis +
         std::sin(polar) * (std::cos(azimuth) * kFirst + std::sin(azimuth) * kSecond);
}

SphereProbe probe_direction(const IncrementalResponse<Tensor>& response, ProbeKind kind,
                            const Eigen::Vector3d& direction) {
  SphereProbe probe;
  probe.polar = std::acos(std::clamp(direction.sum() / std::sqrt(3.0), -1.0, 1.0));
  probe.azimuth = std::atan2((direction(1) - direction(2)) / std::sqrt(2.0),
                             (2 * direction(0) - direction(1) - direction(2)) / std::sqrt(6.0));
  if (probe.azimuth < 0) probe.azimuth += 2 * kPi;
  probe.direction = direction;
  Vector<Tensor> imposed = Vector<Tensor>::Zero();
  imposed.head<3>() = direction;
  const auto rate = answer(response, kind, imposed);
  probe.answered = rate.controllable;
  if (!probe.answered) return probe;
  probe.response = (kind == ProbeKind::stress ? rate.strain : rate.stress).head<3>();
  probe.normalised = rate.normalised_work();
  return probe;
}

Sphere probe_sphere(const IncrementalResponse<Tensor>& response, ProbeKind kind, int rings) {
  if (rings < 6) throw std::invalid_argument("a sphere needs at least 6 rings of directions");
  Sphere sphere{.rings = rings, .sectors = 2 * rings};
  const double step = kPi / rings;
  double unstable_area = 0, area = 0;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < sphere.sectors; ++j) {
      const double polar = (i + 0.5) * step;
      const auto probe = probe_direction(response, kind, sphere_direction(polar, j * step));
      area += std::sin(polar);
      if (!probe.answered) ++sphere.unanswered;
      if (is_unstable(probe)) unstable_area += std::sin(polar);
      if (value(probe.answered, probe.normalised) <
          value(sphere.least.answered, sphere.least.normalised))
        sphere.least = probe;
      sphere.probes.push_back(probe);
    }
  if (sphere.least.answered) {
    const auto [direction, least] =
        descend(sphere.least.direction, step, [&](const Eigen::Vector3d& at) {
          const auto probe = probe_direction(response, kind, at);
          return value(probe.answered, probe.normalised);
        });
    sphere.least = probe_direction(response, kind, direction);
  }
  sphere.unstable_share = unstable_area / area;
  sphere.cones = regions(sphere);
  return sphere;
}

FreeProbe least_of_all_directions(const IncrementalResponse<Tensor>& response, ProbeKind kind,
                                  const SphereProbe& start, int starts) {
  std::vector<Vector<Tensor>> from;
  for (int j = 0; j < Tensor::kSize; ++j)
    for (const double sign : {1.0, -1.0}) from.emplace_back(sign * Vector<Tensor>::Unit(j));
  Vector<Tensor> aligned = Vector<Tensor>::Zero();
  aligned.head<3>() = start.direction;
  if (start.answered) from.push_back(aligned);
  std::mt19937 engine(1);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same directions each time
  std::normal_distribution<double> normal;
  for (int i = 0; i < starts; ++i)
    from.push_back(Vector<Tensor>::NullaryExpr([&] { return normal(engine); }).normalized());

  FreeProbe least;
  for (const auto& direction : from) {
    const auto [at, work] = descend(direction, 0.25, [&](const Vector<Tensor>& v) {
      const auto rate = answer(response, kind, v);
      return value(rate.controllable, rate.normalised_work());
    });
    if (!std::isfinite(work) || (least.answered && least.normalised <= work)) continue;
    least = {at, true, work};
  }
  return least;
}

}  // namespace triax::sim
