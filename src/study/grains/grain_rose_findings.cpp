// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/grains/grain_rose_findings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace triax::study {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

using Probes = std::vector<sim::GrainProbe>;

/// From probe `i` to the next one, around the circle.
double gap_after(const Probes& probes, std::size_t i) {
  return i + 1 < probes.size() ? probes[i + 1].angle - probes[i].angle
                               : probes.front().angle + kTurn - probes.back().angle;
}

double closest(const Probes& probes) {
  double least = kTurn;
  for (std::size_t i = 0; i < probes.size(); ++i) least = std::min(least, gap_after(probes, i));
  return least;
}

/// Larger of what is known, a number or not.
void raise(std::optional<double>& most, double value) {
  if (std::isfinite(value)) most = std::max(most.value_or(0), std::abs(value));
}

void find_gaps(const Probes& made, GrainRoseFindings& found) {
  double all = 0, left = 0, grains = 0;
  for (const auto& probe : made) {
    raise(found.max_boundary_term, probe.work.boundary_part);
    raise(found.max_energy_error, probe.ledger.energy_error_share());
    if (!probe.at_rest) continue;
    all += std::abs(probe.work.gap());
    left += std::abs(probe.work.gap_left());
    grains += probe.work.grains_turning;
  }
  if (!(all > 0) || !std::isfinite(left)) return;
  found.gap_left = left / all;
  found.gap_of_grains = grains / all;
}

}  // namespace

std::vector<AngleRange> ranges_where(const Probes& probes,
                                     const std::function<bool(const sim::GrainProbe&)>& is_so) {
  std::vector<AngleRange> ranges;
  const double widest = 1.5 * closest(probes);
  bool open = false;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const bool in = !probes[i].stopped && is_so(probes[i]);
    if (in && !open) ranges.push_back({probes[i].angle, probes[i].angle, 0});
    if (in) {
      ranges.back().to = probes[i].angle;
      ++ranges.back().directions;
    }
    open = in && gap_after(probes, i) <= widest;
  }
  // One that passes α = 0 began at the end of the list.
  if (open && ranges.size() > 1 && ranges.front().from == probes.front().angle) {
    ranges.back().to = ranges.front().to + kTurn;
    ranges.back().directions += ranges.front().directions;
    ranges.erase(ranges.begin());
  }
  return ranges;
}

std::optional<double> micro_over_macro(const sim::GrainProbe& probe) {
  if (probe.work.lagrangian == 0) return {};
  return probe.work.microscopic() / probe.work.lagrangian;
}

std::optional<double> fixed_over_macro(const sim::GrainProbe& probe) {
  if (probe.work.lagrangian == 0) return {};
  return probe.work.fixed_frame / probe.work.lagrangian;
}

double changed_contacts(const sim::GrainProbe& probe) {
  return probe.sliding_share + probe.work.non_permanent_share();
}

double strain_norm(const sim::GrainProbe& probe) {
  return std::hypot(probe.strain.axial, std::numbers::sqrt2 * probe.strain.radial);
}

GrainRoseFindings rose_findings(const sim::ProbeRose& rose) {
  GrainRoseFindings found;
  Probes made;
  std::copy_if(rose.probes.begin(), rose.probes.end(), std::back_inserter(made),
               [](const auto& probe) { return !probe.stopped; });
  found.made = static_cast<int>(made.size());
  if (made.empty()) return found;
  const auto below = [](auto value) {
    return [value](const auto& a, const auto& b) { return value(a) < value(b); };
  };
  const auto kinetic = [](const auto& probe) { return probe.most_kinetic_j; };
  const auto [quietest, loudest] = std::minmax_element(made.begin(), made.end(), below(kinetic));
  found.at_rest = static_cast<int>(
      std::count_if(made.begin(), made.end(), [](const auto& probe) { return probe.at_rest; }));
  found.most_kinetic_j = loudest->most_kinetic_j;
  for (const auto& probe : made) {
    if (!probe.at_rest || probe.work.normalised >= found.least_normalised.value_or(2)) continue;
    found.least_normalised = probe.work.normalised;
    found.least_angle = probe.angle;
  }
  found.smallest_strain =
      strain_norm(*std::min_element(made.begin(), made.end(), below(strain_norm)));
  if (!rose.null_probe.stopped && *found.smallest_strain > 0)
    found.drift = strain_norm(rose.null_probe) / *found.smallest_strain;

  found.negative = ranges_where(made, [](const auto& p) { return p.work.lagrangian < 0; });
  found.agreeing = ranges_where(made, [](const auto& p) {
    const auto ratio = micro_over_macro(p);
    return ratio && std::abs(*ratio - 1) <= kAgreement;
  });
  const double usual = rose.null_probe.stopped ? 0 : changed_contacts(rose.null_probe);
  found.irreversible = ranges_where(
      made, [usual](const auto& p) { return changed_contacts(p) > usual + kIrreversible; });
  find_gaps(made, found);
  found.not_at_rest = ranges_where(made, [](const auto& p) { return !p.at_rest; });
  found.dynamic = ranges_where(made, [least = quietest->most_kinetic_j](const auto& p) {
    return p.most_kinetic_j > kDynamic * least;
  });
  return found;
}

sim::Circle circle_of(const sim::ProbeRose& rose, sim::ProbeKind kind, double norm) {
  const bool by_stress = kind == sim::ProbeKind::stress;
  sim::Circle circle;
  for (const auto& probe : rose.probes) {
    if (probe.stopped) continue;
    sim::Probe one;
    one.angle = probe.angle;
    one.answered = probe.at_rest;
    const sim::PlaneVector given = norm * sim::unit_direction(probe.angle);
    one.stress =
        by_stress ? given
                  : sim::PlaneVector(std::numbers::sqrt2 * probe.stress.radial, probe.stress.axial);
    one.strain =
        by_stress ? sim::PlaneVector(std::numbers::sqrt2 * probe.strain.radial, probe.strain.axial)
                  : given;
    one.second_order_work = probe.work.lagrangian;
    one.normalised = probe.work.lagrangian / (one.stress.norm() * one.strain.norm());
    circle.probes.push_back(one);
  }
  return circle;
}

}  // namespace triax::study
