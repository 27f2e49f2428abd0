#pragma once
// The bifurcation domain: states of the p′-q plane with a direction of negative second-order work,
// its boundary, and beside it the localisation criterion and the plastic limit.
#include <optional>
#include <string>
#include <vector>

#include "sim/stability/cones.hpp"

namespace triax::sim {

/// States (p′, q) at one void ratio on a regular grid, without memory of a reversal (Law::start).
/// q < 0 is triaxial extension. Columns are p′, independent of each other.
struct DomainGrid {
  double p_from = 0, p_to = 0;  ///< Pa, first and last column
  int columns = 200;
  double q_from = 0, q_to = 0;  ///< Pa
  int rows = 200;
  double void_ratio = 0;
  ProbePlane plane = ProbePlane::axisymmetric;
  int directions = 360;

  double p(int column) const;
  double q(int row) const;
};

enum class DomainStateKind {
  stable,        ///< W₂ > 0 in every direction
  unstable,      ///< inside the bifurcation domain
  beyond_limit,  ///< the law has no such state, or a direction without an answer
  refused,       ///< the law has no meaning there for another reason
};

struct Sector {
  double from = 0, to = 0;  ///< rad, as in Cone
};

struct DomainState {
  double q = 0;  ///< Pa
  DomainStateKind kind = DomainStateKind::refused;
  std::optional<double> least_work;   ///< normalised W₂ of the least direction
  std::optional<double> least_angle;  ///< its α, rad
  std::vector<Sector> cones;
};

/// Where, going away from q = 0 at one p′, each criterion is first met; empty: not on the grid.
struct DomainBoundary {
  std::optional<double> first_unstable_q;      ///< W₂ of the least direction vanishes, Pa
  std::optional<double> first_unstable_angle;  ///< that direction, rad
  std::optional<double> isotropic_unloading_q;  ///< W₂ vanishes for dq = 0, dp′ < 0: the ICU peak
                                                ///< and the CSD collapse
  std::optional<double> determinant_q;  ///< det of the symmetric part vanishes, in a zone that
                                        ///< holds the direction (closed form; octolinear)
  std::optional<double> localisation_q;  ///< det of an acoustic tensor vanishes (Rice)
  std::optional<double> limit_q;         ///< the plastic limit
};

struct DomainColumn {
  int column = 0;
  double p = 0;  ///< Pa
  std::vector<DomainState> states;
  DomainBoundary compression, extension;
};

}  // namespace triax::sim
