// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Probes of a specimen of grains (section 5.2, Figs. 13 to 15 of the paper): from copies of one
// calm state a small increment in a direction α of the Rendulic plane, as sim/stability/probe.hpp
// has it,
//
//   of stress   √2 Δσ₃ = d cos α,  Δσ₁ = d sin α      by servos whose targets are ramps
//   of strain   √2 Δε₃ = d cos α,  Δε₁ = d sin α      natural; walls move steadily, then stop
//
// put on as a ramp and then left until the specimen is at rest. The null probe does the same with
// d = 0: what it shows is the drift that no probe is free of.
#include <cstdint>
#include <vector>

#include "sim/grains/engine/grain_ledger.hpp"
#include "sim/grains/probes/grain_work.hpp"
#include "sim/grains/state/grain_progress.hpp"
#include "sim/grains/state/grain_state.hpp"
#include "sim/mechanics/axisymmetric.hpp"
#include "sim/stability/probe.hpp"

namespace triax::sim {

struct GrainProbing {
  ProbeKind kind = ProbeKind::stress;
  double norm_pa = 1000;           ///< d of stress probes, ≥ 0
  double norm_strain = 1e-5;       ///< d of strain probes, ≥ 0
  std::int64_t ramp_steps = 4000;  ///< > 1
  double unbalanced = 5e-5;        ///< at rest below this (> 0) …
  double stress_error_pa = 2;      ///< … and, of stress probes, this close to its stresses (> 0)
  std::int64_t check_every = 500;  ///< steps
  std::int64_t most_steps = 100000;
  std::int64_t sample_every = 50;     ///< steps between looks at kinetic energy and sliding
  double speed_limit_m_per_s = 0.05;  ///< of each wall
};

struct GrainProbe {
  double angle = 0;           ///< α, rad
  double norm_pa = 0;         ///< d of a stress probe, else 0
  double norm_strain = 0;     ///< d of a strain probe, else 0
  bool at_rest = false;       ///< false: the bound of steps was reached, or it was stopped
  bool stopped = false;       ///< by the progress: its values say nothing
  AxisymmetricStress stress;  ///< what was reached, Pa, on the walls
  AxisymmetricStrain strain;  ///< natural
  GrainWork work;
  GrainLedger ledger;         ///< from the end of its first step to its end
  double most_kinetic_j = 0;  ///< of the samples
  /// Contacts found to have slid (sliding_record.hpp) at a sample at least, over those of the first
  /// state: a lower bound
  double sliding_share = 0;
  std::int64_t steps = 0;
  double unbalanced = 0;       ///< at the end
  double stress_error_pa = 0;  ///< at the end

  bool null() const { return norm_pa == 0 && norm_strain == 0; }
};

/// One probe on one thread; `state` has to be calm (calming.hpp) and is not changed. Throws
/// GrainsFailed, std::invalid_argument on settings out of their ranges.
GrainProbe probe(const GrainState& state, double angle, const GrainProbing& how,
                 const GrainProgress& progress = {});

struct ProbeRose {
  GrainProbe null_probe;
  std::vector<GrainProbe> probes;  ///< as the angles
  bool stopped = false;            ///< some probes were not made
};

/// The null probe and one probe for each angle (rad), `threads` at once with an engine each. The
/// result does not depend on the number of threads. Throws as probe().
ProbeRose probe_rose(const GrainState& state, const std::vector<double>& angles,
                     const GrainProbing& how, int threads, const GrainProgress& progress = {});

/// Some of the probes of a rose: number 0 is the null probe, number k the one at angles[k − 1].
struct SomeProbes {
  std::vector<GrainProbe> probes;  ///< as the numbers; one not made says so
  bool stopped = false;            ///< some were not made
};

/// As probe_rose(), which is this with every number: a probe does not depend on which others are
/// made. Throws std::invalid_argument too on a number that the rose does not have.
SomeProbes some_probes(const GrainState& state, const std::vector<double>& angles,
                       const std::vector<int>& numbers, const GrainProbing& how, int threads,
                       const GrainProgress& progress = {});

/// The numbers of piece `index` (1 to `count`) of a rose with `directions` angles: index − 1, and
/// every count-th from there on. Empty if the rose has fewer probes than there are pieces before.
std::vector<int> numbers_of_piece(int directions, int index, int count);

/// 0, 360°/count, 2·360°/count, …, rad.
std::vector<double> rose_angles(int count = 36);

}  // namespace triax::sim
