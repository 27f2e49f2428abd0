// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The six walls in a step: what drives them, and how far they go.
#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

/// Mean of both walls' pressure on axis `axis`, Pa, as last measured.
double wall_stress(const WallState& walls, const GrainBox& box, int axis);

/// What the servo of a stress-driven axis holds at its target: σ + Σ ratio σ_follower, Pa.
double conjugate_stress(const WallState& walls, const GrainBox& box, int axis);

/// One step of the walls, after their forces were measured. Servo of a stress-driven axis
/// (compression positive; M the stiffness of touching grains against the axis' strain, followers
/// included; gain, smoothing and floor are those of the servo in the literature's codes):
///
///   ε̇ ← 0.9 ε̇ + 0.1 (a + b),  a = g (σ_target − σ)/(M Δt),  g = 0.05, |v| of each wall below its
///   limit
///
/// b is learned where another axis is strained at a given rate, b ← b + a/500: walls that have to
/// move steadily would lag by M Δt ε̇/g without it.
void move_walls(GrainState& state);

/// Throws std::invalid_argument: a leader that follows or is no axis, a limit not above 0, a value
/// that is not finite.
void check(const std::array<AxisDrive, 3>& drives);

/// Largest speed of a wall, m/s.
double wall_speed(const GrainState& state);

}  // namespace triax::sim
