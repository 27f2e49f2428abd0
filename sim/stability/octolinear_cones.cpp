// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/octolinear_cones.hpp"

#include <algorithm>

#include "sim/stability/stability_determinant.hpp"

namespace triax::sim {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSameEdge = 1e-12;  // rad

/// Signs of (dσ₁, dσ₃) in the quadrant that begins at i π/2.
bool loads_axially(int quadrant) { return quadrant < 2; }
bool loads_radially(int quadrant) { return quadrant == 0 || quadrant == 3; }

/// dσ₁ N₂₁ + dσ₃ N₂₃, which dσ₂ N₂₂ balances.
double pushed_out(const PrincipalCompliance& n, double angle) {
  return n(1, 0) * std::sin(angle) + n(1, 2) * std::cos(angle);
}

/// The part of a quadrant in which dσ₂ has the sign of the zone.
std::optional<OctolinearZone> plane_strain_zone(const InterpolatedForm<Tensor>& form, int quadrant,
                                                bool loads_across) {
  OctolinearZone zone;
  zone.signs.loading = {loads_axially(quadrant), loads_across, loads_radially(quadrant)};
  const PrincipalCompliance n = zone_compliance(form, zone.signs);
  zone.from = quadrant * kPi / 2;
  zone.to = zone.from + kPi / 2;
  const double turn = std::atan2(-n(1, 2), n(1, 0));  // where dσ₂ = 0, and at ± π
  for (int half = -1; half <= 2; ++half)
    if (const double edge = turn + half * kPi; edge > zone.from && edge < zone.to) {
      const bool above = (pushed_out(n, (edge + zone.to) / 2) * n(1, 1) < 0) == loads_across;
      (above ? zone.from : zone.to) = edge;
      break;
    }
  const double across = -pushed_out(n, (zone.from + zone.to) / 2) / n(1, 1);
  if ((across > 0) != loads_across) return std::nullopt;
  zone.compliance = plane_compliance(principal_moduli(n));
  return zone;
}

/// The directions around which W₂ is least in a zone of M, α₀ and α₀ + π, with the half opening in
/// which it is negative there.
struct Arc {
  double centre = 0, half = 0;
};
Arc unstable_arc(const Eigen::Matrix2d& m) {
  const double mean = m.trace() / 2;
  const double radius = std::hypot((m(0, 0) - m(1, 1)) / 2, (m(0, 1) + m(1, 0)) / 2);
  const double half = radius > mean ? std::acos(std::max(mean / radius, -1.0)) / 2 : 0;
  return {least_direction(m), half};
}

/// What of the arcs of a zone lies in it.
void cut(const OctolinearZone& zone, std::vector<UnstableSector>& sectors) {
  const Arc arc = unstable_arc(zone.compliance.matrix);
  if (arc.half == 0) return;
  for (int turn = -1; turn <= 2; ++turn) {
    const double from = std::max(zone.from, arc.centre + turn * kPi - arc.half);
    const double to = std::min(zone.to, arc.centre + turn * kPi + arc.half);
    if (from < to) sectors.push_back({from, to});
  }
}

/// Least W₂/|dσ|² in a zone.
double least_of(const OctolinearZone& zone) {
  const double own = least_direction(zone.compliance.matrix);
  double least = std::numeric_limits<double>::infinity();
  for (const double angle : {zone.from, zone.to, own, own + kPi})
    if (zone.contains(angle)) least = std::min(least, zone.compliance.work(angle));
  return least;
}

std::vector<UnstableSector> joined(std::vector<UnstableSector> sectors) {
  std::ranges::sort(sectors, {}, &UnstableSector::from);
  std::vector<UnstableSector> cones;
  for (const UnstableSector& s : sectors) {
    if (!cones.empty() && s.from - cones.back().to <= kSameEdge)
      cones.back().to = std::max(cones.back().to, s.to);
    else
      cones.push_back(s);
  }
  // The one that ends at 2π goes on at 0.
  if (cones.size() > 1 && cones.front().from <= kSameEdge &&
      cones.back().to >= 2 * kPi - kSameEdge) {
    cones.back().to = cones.front().to + 2 * kPi;
    cones.erase(cones.begin());
  }
  return cones;
}

}  // namespace

std::vector<OctolinearZone> octolinear_zones(const InterpolatedForm<Axisymmetric>& form) {
  std::vector<OctolinearZone> zones;
  for (int i = 0; i < 4; ++i) {
    const ZoneSigns signs{{loads_axially(i), loads_radially(i), loads_radially(i)}};
    zones.push_back(
        {signs, i * kPi / 2, (i + 1) * kPi / 2, plane_compliance(zone_compliance(form, signs))});
  }
  return zones;
}

std::vector<OctolinearZone> octolinear_zones(const InterpolatedForm<Tensor>& form) {
  std::vector<OctolinearZone> zones;
  for (int i = 0; i < 4; ++i)
    for (const bool across : {true, false})
      if (const auto zone = plane_strain_zone(form, i, across)) zones.push_back(*zone);
  std::ranges::sort(zones, {}, &OctolinearZone::from);
  return zones;
}

bool answers_in_plane_strain(const InterpolatedForm<Tensor>& form) {
  return form.plus(1, 1) > 0 && form.minus(1, 1) > 0;
}

std::vector<UnstableSector> unstable_sectors(const std::vector<OctolinearZone>& zones) {
  std::vector<UnstableSector> sectors;
  for (const OctolinearZone& zone : zones) cut(zone, sectors);
  return joined(std::move(sectors));
}

double least_work(const std::vector<OctolinearZone>& zones) {
  double least = std::numeric_limits<double>::infinity();
  for (const OctolinearZone& zone : zones) least = std::min(least, least_of(zone));
  return least;
}

std::optional<double> least_determinant(const std::vector<OctolinearZone>& zones) {
  std::optional<double> least;
  for (const OctolinearZone& zone : zones) {
    const double own = least_direction(zone.compliance.matrix);
    if (!zone.contains(own) && !zone.contains(own + kPi)) continue;
    const double value = relative_determinant(zone.compliance.matrix);
    if (!least || value < *least) least = value;
  }
  return least;
}

}  // namespace triax::sim
