// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Roots of Eqs. (34) and (35): where control of a proportional strain path is lost.
//
// What a root leaves free is a stress increment ±(1, R) of (dσ₁, dσ₃), and the moduli of the
// equations are those of the law for that very increment: M depends on the direction, Eq. (24). By
// homogeneity dε = M(dσ) dσ the quadratic is then W₂ of the law's own response, so that a root is a
// direction in which that vanishes. The same search, around the circle of directions, serves every
// law. With moduli of one tensorial zone the quadratic can be solved in closed form, and its roots
// are those of an octolinear law where their direction lies in the zone, dσ₂ included (in plane
// strain dσ₂ may rise while dσ₁ and dσ₃ fall); a law without zones has no such roots.
#include <vector>

#include "sim/stability/probe.hpp"

namespace triax::sim {

/// A root, with the mode that it leaves free.
struct ControlRoot {
  double R = 0;
  double angle = 0;         ///< α of the mode's stress increment, rad in [0, 2π)
  double failure_rule = 0;  ///< dε₁/dσ₃ of the mode, which Eqs. (40), (41) give in a zone, 1/Pa
  double normalised = 0;    ///< W₂ of the mode, normalised: 0 to kVanishing
};

/// |W₂| normalised that counts as none.
inline constexpr double kVanishing = 1e-6;

struct ControlRoots {
  std::vector<ControlRoot> roots;  ///< by rising R
  int unanswered = 0;              ///< of the directions tried
};

/// Changes of the sign of W₂ around the circle of stress directions (cones.hpp), isolated to 1e-12
/// rad, at which it vanishes. R = ±∞ (dσ₁ = 0) is left out. Where the law has no answer there is no
/// root; a cone that ends there ends without one.
template <class Space>
ControlRoots control_roots(const IncrementalResponse<Space>& response);

}  // namespace triax::sim
