// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Roots of Eqs. (34) and (35): where control of a proportional strain path is lost.
//
// The moduli of the equations are those of one tensorial zone, and what a root leaves free is a
// stress increment ±(1, R) of (dσ₁, dσ₃): only where that increment lies in the zone whose moduli
// gave the root, dσ₂ included, is it a root of the law. In plane strain dσ₂ may rise while dσ₁ and
// dσ₃ fall, and the zone is then (−, +, −), not the (−, −, −) of the paper's own examples. So every
// zone is tried, and every root tells its own. In all, the roots are the edges of the cones.
#include <optional>
#include <vector>

#include "sim/stability/octolinear_cones.hpp"

namespace triax::sim {

/// A root, with the mode that it leaves free.
struct ControlRoot {
  double R = 0;
  double angle = 0;               ///< α of the mode's stress increment, rad in [0, 2π)
  double failure_rule = 0;        ///< dε₁/dσ₃ of Eq. (40) or (41), 1/Pa
  std::optional<ZoneSigns> zone;  ///< of the moduli; empty: those of the tangent of `angle`
};

/// Of a law that is linear in zones, by rising R. The zones may be those of octolinear made with
/// the moduli of INL2: the roots are then octolinear's. R = ±∞ (dσ₁ = 0) is left out.
std::vector<ControlRoot> control_roots(const std::vector<OctolinearZone>& zones);

/// Of any law, by rising R: the edges of the cones that probes find, each with the root, of the
/// quadratic of its own tangent compliance, that its direction is. A cone that ends where the law
/// has no answer has no root there.
template <class Space>
std::vector<ControlRoot> control_roots(const IncrementalResponse<Space>& response);

}  // namespace triax::sim
