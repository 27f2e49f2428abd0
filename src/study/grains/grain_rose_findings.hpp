// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the probes of a rose show together. A probe that was stopped says nothing and is left out.
#include <functional>
#include <optional>
#include <vector>

#include "sim/grains/probes/grain_probe.hpp"
#include "sim/stability/cones.hpp"

namespace triax::study {

/// Neighbouring probed directions, both ends included; `to` may lie beyond 2π.
struct AngleRange {
  double from = 0, to = 0;  ///< rad, from ≤ to
  int directions = 0;       ///< probed in it
};

/// Ranges of directions whose probes are so. A direction not probed ends a range: one that is
/// farther from its neighbour than half as much again as the closest two are. All around is one
/// range from the first to the last. Pre-condition: probes in ascending order of their angles, from
/// 0 to below 2π.
std::vector<AngleRange> ranges_where(const std::vector<sim::GrainProbe>& probes,
                                     const std::function<bool(const sim::GrainProbe&)>& is_so);

/// Microscopic over semi-Lagrangian W₂; empty where that is 0.
std::optional<double> micro_over_macro(const sim::GrainProbe& probe);
/// The sum over contacts in a frame at rest over semi-Lagrangian W₂: 1 between two equilibria.
std::optional<double> fixed_over_macro(const sim::GrainProbe& probe);
/// Sliding and non-permanent contacts over those at the start.
double changed_contacts(const sim::GrainProbe& probe);
/// |ε| in the Rendulic plane.
double strain_norm(const sim::GrainProbe& probe);

struct GrainRoseFindings {
  int made = 0, at_rest = 0;
  std::vector<AngleRange> negative;  ///< semi-Lagrangian W₂ < 0: cones of unstable directions
  std::vector<AngleRange> agreeing;  ///< micro- and macroscopic W₂ within kAgreement
  /// Sliding and non-permanent contacts together more than kIrreversible above the null probe's:
  /// contacts that are at their limit already when the probes begin count in all of them.
  std::vector<AngleRange> irreversible;
  std::vector<AngleRange> dynamic;        ///< kinetic energy above kDynamic times the least
  std::vector<AngleRange> not_at_rest;    ///< did not come to rest within the bound of steps
  std::optional<double> smallest_strain;  ///< strain_norm of the probes
  std::optional<double> drift;  ///< strain_norm of the null probe over that; empty: not made
  double most_kinetic_j = 0;
  /// Smallest normalised W₂ of the probes at rest and where (rad); empty: none came to rest.
  std::optional<double> least_normalised, least_angle;

  /// Of the probes at rest, over the sum of |microscopic − semi-Lagrangian W₂|: what the turning of
  /// grains and of contacts and the lack of balance leave unexplained of it, and what the grains'
  /// turning alone makes up. Empty where parts of the gap are not known, or there is none.
  std::optional<double> gap_left, gap_of_grains;
  std::optional<double> max_boundary_term;  ///< largest |boundary term of Eq. (22)|, J/m³
  std::optional<double> max_energy_error;   ///< largest error of an energy balance, relative

  /// The null probe strains so much of the smallest probe's strain that signs of W₂ are in doubt.
  bool drifts() const { return drift && *drift > kMuchDrift; }
  static constexpr double kMuchDrift = 0.1;
};

inline constexpr double kAgreement = 0.03;
inline constexpr double kIrreversible = 0.01;  ///< of the contacts at the start
inline constexpr double kDynamic = 100;

GrainRoseFindings rose_findings(const sim::ProbeRose& rose);

/// The probes that were made, as probes of a law are told: the direction of norm `norm` (Pa of
/// stress probes, a strain of strain probes), what answered in the Rendulic plane and W₂ (Eq. 7);
/// one that did not come to rest is not answered.
sim::Circle circle_of(const sim::ProbeRose& rose, sim::ProbeKind kind, double norm);

}  // namespace triax::study
