// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cones of unstable directions: where W₂ < 0 on the circle of directions of a plane (Fig. 12).
#include <vector>

#include "sim/stability/probe.hpp"

namespace triax::sim {

/// A sector of directions with W₂ < 0.
struct Cone {
  double from = 0, to = 0;  ///< rad, from < to; `from` in [0, 2π), `to` may lie beyond 2π
  Probe strongest;          ///< the direction with the least normalised W₂ in it
  double opening() const { return to - from; }
  bool contains(double angle) const;  ///< whatever turns of 2π it is away
};

struct CircleOptions {
  int directions = 36;  ///< equal steps from α = 0, at least 8
  /// Of a cone's edges and of the least direction, rad. The steps are refined to it about every
  /// change of sign and every local minimum (and every maximum within a cone), so that a cone
  /// between two steps is found too, and a gap in one.
  double precision = 1e-10;
  bool keep_probes = true;  ///< false: the result holds no probes (grids of states)
};

/// The second-order work around the circle.
struct Circle {
  std::vector<Probe> probes;  ///< the steps and those that refined them, by angle, each once
  std::vector<Cone> cones;    ///< by `from`
  Probe least;                ///< with the least normalised W₂ of all that were answered
  int unanswered = 0;         ///< steps without an answer
  int refused = 0;            ///< of these, directions that the law refuses (Probe::refused)
  bool unstable() const { return !cones.empty(); }
};

/// Normalised W₂ below which a direction counts as unstable: round-off of the norms.
inline constexpr double kUnstable = -1e-12;

/// Probes all directions. A cone ends too where the law has no answer.
Circle probe_circle(const Prober& prober, const CircleOptions& options = {});

}  // namespace triax::sim
