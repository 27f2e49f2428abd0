// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/sphere.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <stdexcept>
#include <utility>

namespace triax::sim {
namespace {

constexpr double kHalfTurn = std::numbers::pi;
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

/// The cells of a sphere that was probed at their centres.
class Cells {
 public:
  explicit Cells(const Sphere& sphere)
      : sphere_(sphere), step_(kHalfTurn / sphere.rings), unstable_(sphere.probes.size()) {
    for (std::size_t i = 0; i < unstable_.size(); ++i) unstable_[i] = is_unstable(sphere.probes[i]);
  }

  int count() const { return sphere_.rings * sphere_.sectors; }
  bool unstable(int cell) const { return unstable_[static_cast<std::size_t>(cell)]; }

  /// Solid angle of a cell, or of a part of it in polar angle, over 4π.
  double share(int ring, double from = 0, double to = 1) const {
    return (std::cos((ring + from) * step_) - std::cos((ring + to) * step_)) /
           (2 * sphere_.sectors);
  }

  int cell_of(const SphereProbe& probe) const {
    const int ring = std::min(static_cast<int>(probe.polar / step_), sphere_.rings - 1);
    return at(ring, static_cast<int>(std::lround(probe.azimuth / step_)));
  }

  /// The azimuth is periodic; beyond the first and the last ring lies the cell across the pole.
  int at(int ring, int sector) const {
    const int n = sphere_.sectors;
    if (ring < 0 || ring >= sphere_.rings) {
      ring = std::clamp(ring, 0, sphere_.rings - 1);
      sector += n / 2;
    }
    return ring * n + (sector % n + n) % n;
  }

  /// The eight around a cell.
  std::array<int, 8> around(int cell) const {
    const int ring = cell / sphere_.sectors, sector = cell % sphere_.sectors;
    return {at(ring - 1, sector),     at(ring + 1, sector),     at(ring, sector - 1),
            at(ring, sector + 1),     at(ring - 1, sector - 1), at(ring - 1, sector + 1),
            at(ring + 1, sector - 1), at(ring + 1, sector + 1)};
  }

  /// Cells that the boundary of the unstable directions may cross: those with a neighbour of the
  /// other kind, and those about the least direction, which may lie in a cone within one cell.
  std::vector<bool> at_boundary() const {
    std::vector<bool> marked(unstable_.size(), false);
    const auto mark = [&](int cell) { marked[static_cast<std::size_t>(cell)] = true; };
    for (int cell = 0; cell < count(); ++cell)
      for (const int other : around(cell))
        if (unstable(cell) != unstable(other)) mark(cell);
    if (sphere_.unstable() && !unstable(cell_of(sphere_.least))) {
      mark(cell_of(sphere_.least));
      for (const int other : around(cell_of(sphere_.least))) mark(other);
    }
    return marked;
  }

  /// Connected regions of unstable cells; neighbours share a side, or a pole.
  int regions() const {
    std::vector<bool> open = unstable_;
    int count = 0;
    for (int first = 0; first < this->count(); ++first) {
      if (!open[static_cast<std::size_t>(first)]) continue;
      ++count;
      std::vector<int> waiting{first};
      while (!waiting.empty()) {
        const int cell = waiting.back();
        waiting.pop_back();
        if (!open[static_cast<std::size_t>(cell)]) continue;
        open[static_cast<std::size_t>(cell)] = false;
        const auto near = around(cell);
        waiting.insert(waiting.end(), near.begin(), near.begin() + 4);
      }
    }
    return count;
  }

 private:
  const Sphere& sphere_;
  double step_;
  std::vector<bool> unstable_;
};

double unstable_share(const IncrementalResponse<Tensor>& response, ProbeKind kind,
                      const Sphere& sphere, const Cells& cells) {
  constexpr int kParts = 6;
  const double step = kHalfTurn / sphere.rings;
  const auto cut = cells.at_boundary();
  double share = 0;
  for (int cell = 0; cell < cells.count(); ++cell) {
    const int ring = cell / sphere.sectors, sector = cell % sphere.sectors;
    if (!cut[static_cast<std::size_t>(cell)]) {
      if (cells.unstable(cell)) share += cells.share(ring);
      continue;
    }
    for (int i = 0; i < kParts; ++i)
      for (int j = 0; j < kParts; ++j) {
        const double polar = (ring + (i + 0.5) / kParts) * step;
        const double azimuth = (sector - 0.5 + (j + 0.5) / kParts) * step;
        if (is_unstable(probe_direction(response, kind, sphere_direction(polar, azimuth))))
          share += cells.share(ring, 1.0 * i / kParts, (i + 1.0) / kParts) / kParts;
      }
  }
  return share;
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
  if (probe.azimuth < 0) probe.azimuth += 2 * kHalfTurn;
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
  const double step = kHalfTurn / rings;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < sphere.sectors; ++j) {
      const double polar = (i + 0.5) * step;
      const auto probe = probe_direction(response, kind, sphere_direction(polar, j * step));
      if (!probe.answered) ++sphere.unanswered;
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
  const Cells cells(sphere);
  sphere.unstable_share = unstable_share(response, kind, sphere, cells);
  sphere.regions = std::max(cells.regions(), sphere.unstable() ? 1 : 0);
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
