// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/without_guard.hpp"

#include <cmath>
#include <utility>

#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

namespace triax::lab {

std::function<GuardOutcome::Without()> without_guard(const Programme& programme,
                                                     std::optional<std::uint64_t> seed,
                                                     std::function<bool()> stop) {
  if (!programme.guard) return {};
  return [unguarded = programme, seed, stop = std::move(stop)]() mutable {
    unguarded.guard.reset();
    VirtualRig rig(unguarded, seed);
    GuardOutcome::Without without;
    const SessionListener listener{.scanned =
                                       [&](const Reading&, const State& state) {
                                         if (!std::isnan(state.strain.axial))
                                           without.last_axial_strain = state.strain.axial;
                                       },
                                   .happened =
                                       [&](const Event& event) {
                                         if (event.kind == EventKind::lost && !without.lost)
                                           without.lost = Moment{event.reading, event.time_s};
                                       }};
    without.kind = run_session(rig, {.reduction = {}, .stop = stop}, {listener}).collapse.kind;
    return without;
  };
}

}  // namespace triax::lab
