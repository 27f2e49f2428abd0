// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The bifurcation domain: states of the p′-q plane with a direction of negative second-order work,
// its boundary, and beside it criteria of other kinds and the plastic limit (section 4 of the
// paper).
//
// A state stands alone: σ′ and e, without memory of a reversal (Law::start), σ₂ = σ₃. Going away
// from q = 0 at one p′ the criteria are met in this order by a sand: first unstable direction,
// isotropic unloading, plastic limit.
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/law/parameters.hpp"
#include "sim/stability/cones.hpp"

namespace triax::sim {

/// States (p′, q) at one void ratio on a regular grid, ends included. q < 0 is triaxial extension.
/// Columns are p′, independent of each other: the unit of work of threads and of pieces.
struct DomainGrid {
  double p_from = 0, p_to = 0;  ///< Pa, first and last column, above 0
  int columns = 200;
  double q_from = 0, q_to = 0;  ///< Pa, first and last row, q_from < q_to
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
  unknown,       ///< W₂ > 0 in the directions that the law answers, which are not all
  beyond_limit,  ///< a stress direction without an answer where the law refuses none, the law's
                 ///< objection is that of its limit, or the state lies behind such a one
  refused,       ///< the law has no meaning there for another reason, or answers no direction
};

inline constexpr std::array kDomainStateKinds = {
    DomainStateKind::stable, DomainStateKind::unstable, DomainStateKind::unknown,
    DomainStateKind::beyond_limit, DomainStateKind::refused};

struct Sector {
  double from = 0, to = 0;  ///< rad, as in Cone
};

struct DomainState {
  double q = 0;  ///< Pa
  DomainStateKind kind = DomainStateKind::refused;
  std::optional<double> least_work;   ///< normalised W₂ of the least direction
  std::optional<double> least_angle;  ///< its α, rad
  std::vector<Sector> cones;
  int refused_directions = 0;  ///< that the law cannot follow (Law::refusal): nothing known there
};

/// Where, going away from q = 0 at one p′, each criterion is first met, also below the first row.
/// Empty: not before the last row of that side; or behind a state that is refused, or where a
/// direction that is not refused has no answer; or only there, as at the plastic limit. Isolated
/// between the rows, to kDomainPrecision. q = 0 itself is the answer where a criterion is met there
/// already. Of directions that the law refuses nothing is known.
struct DomainBoundary {
  std::optional<double> first_unstable_q;      ///< W₂ of the least direction vanishes, Pa
  std::optional<double> first_unstable_angle;  ///< that direction, rad
  std::optional<double> isotropic_unloading_q;  ///< W₂ vanishes for dσ₁ = dσ₃ < 0. Axisymmetric:
                                                ///< dq = 0, dp′ < 0, the ICU peak and CSD collapse
  std::optional<double> limit_q;  ///< the plastic limit: the last state before beyond_limit
  /// Of criteria of other kinds (domain_criteria.hpp) by name: those that are met, Pa.
  std::map<std::string, double, std::less<>> others_q;
  std::optional<double> other_q(std::string_view name) const;
};

/// Of q, as a share of the larger of |q| and the distance of two rows.
inline constexpr double kDomainPrecision = 1e-10;

struct DomainColumn {
  int column = 0;
  double p = 0;  ///< Pa
  std::vector<DomainState> states;
  DomainBoundary compression, extension;
  std::string refusal;  ///< the law's words on the first state or direction refused; empty: none
};

/// σ′ of a state of the grid, σ₂ = σ₃.
template <class Space>
Vector<Space> domain_stress(double p, double q) {
  auto stress = components(AxisymmetricStress{p + 2 * q / 3, p - q / 3});
  if constexpr (Space::kSize == 2)
    return stress;
  else
    return as_tensor(stress);
}

/// A criterion of another kind at the state (p′, q) in Pa: above 0 where it is not met yet, below
/// where it is; empty where it says nothing, which counts as not met.
using DomainWitness = std::function<std::optional<double>(double p, double q)>;
struct DomainCriterion {
  std::string name;
  DomainWitness witness;
  /// States a side that are looked at, beside those where it is met: fewer than the rows for one
  /// that is slow.
  std::size_t most_rows = std::numeric_limits<std::size_t>::max();
};
using DomainCriteria = std::vector<DomainCriterion>;

/// One column, by stress probes of the rates. Axisymmetric plane. A law that fails at a state
/// (std::runtime_error of a foreign one) refuses it.
DomainColumn domain_column(const Law<Axisymmetric>& law, const DomainGrid& grid, int column,
                           const DomainCriteria& criteria = {});
/// Plane strain.
DomainColumn domain_column(const Law<Tensor>& law, const DomainGrid& grid, int column,
                           const DomainCriteria& criteria = {});

/// The same with the law for the grid's plane; throws std::invalid_argument where the material has
/// none.
DomainColumn domain_column(const Material& material, const DomainGrid& grid, int column,
                           const DomainCriteria& criteria = {});

}  // namespace triax::sim
