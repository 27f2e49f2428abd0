// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether an equilibrium on a strain path is sustained (section 5.3, Figs. 17 and 18 of the paper):
// under dε₁ + 2R dε₃ = 0 and σ₁ − σ₃/R as the controls a small perturbation is given, and the
// specimen is followed until it is at rest again or has collapsed.
#include <cstdint>
#include <vector>

#include "sim/grains/engine/calming.hpp"
#include "sim/grains/state/grain_progress.hpp"
#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

/// A state from a moving path brought to an equilibrium at its strain: walls stopped, motion taken
/// out, at rest, calmed. (Under stress control a state past the peak could run away meanwhile.) Its
/// σ₁ − σ₃/R is a little lower then. Throws GrainsFailed.
struct Equilibrium {
  GrainState state;           ///< walls at rest
  double path_stress_pa = 0;  ///< σ₁ − σ₃/R that it carries
  Settled rest;
  GrainLedger ledger;  ///< from the end of the first step to the last
};
Equilibrium equilibrium_at(const GrainState& state, double ratio, const Settling& settling = {},
                           int threads = 1, const GrainProgress& progress = {});

struct Perturbation {
  double ratio = 0.825;         ///< R, > 0
  double load_step_pa = 0;      ///< added to σ₁ − σ₃/R at once
  double kinetic_energy_j = 0;  ///< ≥ 0, given to floating grains
  double floating_share = 0.5;  ///< of the floating grains, chosen by the seed, that get it; (0, 1]
  std::uint64_t seed = 1;
  double speed_limit_m_per_s = 0.2;  ///< of each wall

  /// At rest: unbalanced below this, σ₁ − σ₃/R this close to what is held, and kinetic energy below
  /// this share of what was given (of a load step: below half of its largest), at three checks in a
  /// row.
  double unbalanced = 1e-4, stress_error_pa = 10, energy_share = 0.1;
  /// Collapsed: p below this share of what it was, or ε₁ grown by more than this.
  double collapse_share = 0.5, collapse_strain = 0.01;
  std::int64_t check_every = 100;  ///< steps, > 0
  double longest_s = 1;            ///< followed no longer than this, > 0
  int samples = 400;               ///< at most so many points are kept, > 2
};

struct PerturbationPoint {
  double time_s = 0;
  double path_stress_pa = 0;  ///< σ₁ − σ₃/R
  double stress_share = 0;    ///< χ: over what it was at the start
  double p_pa = 0;
  double axial_strain = 0;      ///< since the perturbation
  double kinetic_energy_j = 0;  ///< the most since the point before
  double unbalanced = 0;
};

enum class PerturbationEnd : std::uint8_t { at_rest, collapsed, undecided, stopped };

struct PerturbationResult {
  PerturbationEnd end = PerturbationEnd::undecided;  ///< undecided: followed to the longest time
  std::vector<PerturbationPoint> points;
  std::int64_t grains_hit = 0;  ///< that were given energy
  double most_kinetic_j = 0;    ///< after the start
  GrainState state;             ///< at the end
  GrainLedger ledger;           ///< from the end of the first step to the last
};

/// Gives `energy_j` to floating grains, each the same speed in a random direction, and returns how
/// many. Throws std::invalid_argument if energy is asked for and no grain floats.
std::int64_t give_energy(Grains& grains, double energy_j, double share, std::uint64_t seed);

/// Perturbs a state that is in equilibrium (equilibrium_at). With no load and no energy it shows
/// whether the state rests under its controls. Throws GrainsFailed, std::invalid_argument on
/// settings out of their ranges or a state whose σ₁ − σ₃/R is 0.
PerturbationResult perturb(const GrainState& equilibrium, const Perturbation& how, int threads = 1,
                           const GrainProgress& progress = {});

}  // namespace triax::sim
