// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <span>

#include "lab/measured/path_rates.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// Where a specimen that fell between two readings lost its equilibrium, from the readings before.
///
/// Under a load or a spring q passes its peak there. Near it the tangent modulus falls linearly
/// with the stress ratio, dq/dε₁ = k (η_c − η), so that
///   q − q₀ = k η_c (ε₁ − ε₁,₀) − k ∫η dε₁
/// is linear in its two unknowns: least squares over the last 24 readings give the root η_c and its
/// error. Under the same law and a load that grows steadily η advances over a time τ that is left
/// at the last reading by 2 η̇ τ, twice what it would by its rate; the fall took place within the
/// next interval, so that η_c = η_l + η′ ± η′/√3 with the rate η′ a reading. Both count, each by
/// its precision, and what they differ by is an error of both. Where q had passed its peak before
/// the last reading by three standard errors (a spring lets it) the vertex of the parabola of q
/// over ε₁ stands in the place of the second. q is q_l + q′τ, and the strains, linear in η, are
/// as far as η is.
///
/// At held q the last reading counts: the specimen yields by itself before it falls, and may have
/// lost its equilibrium up to four readings before.
///
/// `samples`: single readings, oldest first, the last one that before the fall. Empty for fewer
/// than 8 of them, or where the ratio does not grow towards a fall of the modulus.
struct FallFit {
  PathPoint point;
  StressInterval interval;
};
std::optional<FallFit> fit_fall(std::span<const PathSample> samples, bool held_q);

}  // namespace triax::lab
