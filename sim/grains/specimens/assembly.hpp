// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Making a specimen: a loose cloud, compressed from all sides with a friction of its own, which
// decides how dense it becomes.
#include <cstdint>

#include "sim/grains/specimens/cloud.hpp"
#include "sim/grains/state/contact_law.hpp"
#include "sim/grains/state/grain_progress.hpp"
#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

struct Compaction {
  double pressure_pa = 1e5;           ///< > 0
  double friction_angle = 0.0872665;  ///< while it is compressed, rad; here 5°
  double wall_speed_m_per_s = 0.2;    ///< at most, > 0
  double unbalanced = 1e-3;           ///< calm below this …
  double pressure_share = 0.01;       ///< … and this close to the pressure on every axis
  std::int64_t most_steps = 2000000;
};

struct Compacted {
  GrainState state;
  bool calm = false;     ///< false: the bound of steps was reached, or it was stopped
  bool stopped = false;  ///< by the progress
  double porosity = 0;
};

/// Compresses a cloud with servo walls at the friction of compaction until it is calm, then gives
/// it the friction of `law` and waits until it is calm again. The time step follows the critical
/// one (factor 0.6) as contacts form. All axes stay stress-driven at the pressure. Throws
/// std::invalid_argument (law, settings), GrainsFailed (guarded_steps.hpp) if a grain got outside.
/// The bits are the same on any number of threads.
Compacted compact(const Cloud& cloud, const ContactLaw& law, const Compaction& how, int threads = 1,
                  const GrainProgress& progress = {});

}  // namespace triax::sim
