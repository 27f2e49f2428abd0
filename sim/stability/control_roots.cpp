// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/control_roots.hpp"

#include <algorithm>

#include "sim/stability/cones.hpp"
#include "sim/stability/plane_rate.hpp"

namespace triax::sim {
namespace {

constexpr double kSameDirection = 1e-9;  // rad, of a root that two zones share on their edge
constexpr double kOwnTangent = 1e-3;     // rad, within which a root is that of its direction

/// The two increments that a root leaves free, of loading and of unloading along axis 1.
std::array<double, 2> directions_of(ProbePlane plane, double R) {
  const double angle = failure_angle(plane, R);
  return {angle, angle + std::numbers::pi};
}

bool same_direction(const ControlRoot& a, const ControlRoot& b) {
  return std::abs(std::remainder(a.angle - b.angle, 2 * std::numbers::pi)) < kSameDirection;
}

std::vector<ControlRoot> by_ratio(std::vector<ControlRoot> roots) {
  std::ranges::sort(roots, [](const ControlRoot& a, const ControlRoot& b) {
    return a.R != b.R ? a.R < b.R : a.angle < b.angle;
  });
  return roots;
}

/// The root of a tangent that lies in its direction.
std::optional<ControlRoot> own_root(const PlaneCompliance& tangent, double angle) {
  for (const double R : control_quadratic(tangent).roots())
    for (const double direction : directions_of(tangent.plane, R))
      if (std::abs(std::remainder(direction - angle, 2 * std::numbers::pi)) < kOwnTangent)
        return ControlRoot{R, direction, failure_rule(tangent, R), {}};
  return std::nullopt;
}

}  // namespace

std::vector<ControlRoot> control_roots(const std::vector<OctolinearZone>& zones) {
  std::vector<ControlRoot> roots;
  for (const OctolinearZone& zone : zones)
    for (const double R : control_quadratic(zone.compliance).roots())
      for (const double angle : directions_of(zone.compliance.plane, R)) {
        const ControlRoot root{R, angle, failure_rule(zone.compliance, R), zone.signs};
        const auto known = [&root](const ControlRoot& r) { return same_direction(r, root); };
        if (zone.contains(angle) && std::ranges::none_of(roots, known)) roots.push_back(root);
      }
  return by_ratio(std::move(roots));
}

template <class Space>
std::vector<ControlRoot> control_roots(const IncrementalResponse<Space>& response) {
  const Circle circle =
      probe_circle([&](double angle) { return stress_probe(stress_rate(response, angle)); },
                   {.keep_probes = false});
  std::vector<ControlRoot> roots;
  for (const Cone& cone : circle.cones)
    for (const double edge : {cone.from, cone.to}) {
      const auto tangent = plane_compliance(response, stress_rate(response, edge));
      if (!tangent) continue;
      if (const auto root = own_root(*tangent, edge)) roots.push_back(*root);
    }
  return by_ratio(std::move(roots));
}

template std::vector<ControlRoot> control_roots(const IncrementalResponse<Axisymmetric>&);
template std::vector<ControlRoot> control_roots(const IncrementalResponse<Tensor>&);

}  // namespace triax::sim
