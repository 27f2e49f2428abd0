// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/control_roots.hpp"

#include <algorithm>
#include <optional>

#include "sim/stability/cones.hpp"
#include "sim/stability/plane_rate.hpp"

namespace triax::sim {
namespace {

constexpr CircleOptions kCircle{.directions = 72, .precision = 1e-12, .keep_probes = false};
constexpr double kInfiniteRatio = 1e-9;  // |sin α| below which R has no meaning

template <class Space>
std::optional<ControlRoot> root_at(const Prober& prober, double edge) {
  const double angle = std::fmod(edge, 2 * std::numbers::pi);
  const double weight = kPlane<Space> == ProbePlane::axisymmetric ? std::numbers::sqrt2 : 1;
  const Probe mode = prober(angle);
  if (!mode.answered || !(std::abs(mode.normalised) < kVanishing)) return std::nullopt;
  if (std::abs(std::sin(angle)) < kInfiniteRatio) return std::nullopt;
  return ControlRoot{mode.stress.x() / (weight * mode.stress.y()), angle,
                     weight * mode.strain.y() / mode.stress.x(), mode.normalised};
}

}  // namespace

template <class Space>
ControlRoots control_roots(const IncrementalResponse<Space>& response) {
  // The prober does not outlive the response, and need not own it.
  const Prober prober = make_prober(
      std::shared_ptr<const IncrementalResponse<Space>>(std::shared_ptr<void>(), &response),
      ProbeKind::stress);
  const Circle circle = probe_circle(prober, kCircle);
  ControlRoots found{.roots = {}, .unanswered = circle.unanswered};
  for (const Cone& cone : circle.cones)
    for (const double edge : {cone.from, cone.to})
      if (const auto root = root_at<Space>(prober, edge)) found.roots.push_back(*root);
  std::ranges::sort(found.roots, [](const ControlRoot& a, const ControlRoot& b) {
    return a.R != b.R ? a.R < b.R : a.angle < b.angle;
  });
  return found;
}

template ControlRoots control_roots(const IncrementalResponse<Axisymmetric>&);
template ControlRoots control_roots(const IncrementalResponse<Tensor>&);

}  // namespace triax::sim
