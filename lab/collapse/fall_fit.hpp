// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <span>

#include "lab/measured/path_rates.hpp"
#include "lab/measured/pore_fluid.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// Where a specimen that fell between two readings lost its equilibrium, from the readings before.
///
/// Under a load or a spring q passes its peak there. Near it the tangent modulus falls linearly
/// with the stress ratio, dq/dε₁ = k (η_c − η), so that
///   q − q₀ = k η_c (ε₁ − ε₁,₀) − k ∫η dε₁
/// is linear in its two unknowns: least squares over the last 24 readings give the root η_c and its
/// error.
///
/// Where q grew up to the end as over the stage a load drove it, and the fall took place within the
/// next interval. Under the same law η then advances over a time τ that is left at the last reading
/// by 2 η̇ τ, twice what it would by its rate: η_c = η_l + η′ ± η′/√3 with the rate η′ a reading. It
/// and the root count, each by its precision, and what they differ by is an error of both. q is
/// q_l + q′τ, τ at most one reading, and its interval that from q_l to q_l + q′.
///
/// Where q had stopped growing a spring let it, and it may have passed its peak at any reading
/// where its slope cannot be told from zero (Turned): the interval is that stretch, and the next
/// interval, too, where the slope cannot be told from zero at its end.
///
/// Where pore fluid is compressed (`compliance`, of a closed valve) second-order work
/// dq dε_q + c du dp′ vanishes before q has its peak, with the rates along ε₁:
///   dq/dε₁ = −c (du/dε₁)(dp′/dε₁),  so η is less than η_c by −c (du/dε₁)(dp′/dε₁)/k,
/// and its interval reaches over that of c.
///
/// At held q the last reading counts: the specimen yields by itself before it falls, and may have
/// lost its equilibrium up to four readings before, or from where the volume may have turned, and
/// before that while a loop that searches outdid the trend (servo_search.hpp); until the next
/// reading at the latest, one and a half after the middle of the interval whose mean is the last.
///
/// `all`: single readings, oldest first, the last one that before the fall; 60 of them tell a
/// load from a spring. `rate_of_stage`: of q, Pa a reading, over the stage. Empty for fewer than 8
/// of them, or where the ratio does not grow towards a fall of the modulus.
struct FallFit {
  PathPoint point;
  StressInterval interval;
};
std::optional<FallFit> fit_fall(std::span<const PathSample> all, bool held_q, double rate_of_stage,
                                const std::optional<FluidCompliance>& compliance = {});

}  // namespace triax::lab
