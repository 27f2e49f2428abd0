// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace triax::lab {

/// First-order lag, exact for a drive that is linear over the step:
///   τ ẏ = x(t) − y,   x(t) = x₀ + (x₁ − x₀) t/Δt
/// gives y at Δt from y at 0. τ = 0 follows at once: y = x₁ to the bit. Pre-conditions: τ ≥ 0,
/// Δt ≥ 0 (0 leaves y as it is unless τ = 0).
double first_order(double y, double x_start, double x_end, double dt_s, double time_constant_s);

}  // namespace triax::lab
