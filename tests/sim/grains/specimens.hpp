// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Compacted specimens for tests, made once each.
#include "sim/grains/engine/calming.hpp"
#include "sim/grains/engine/grains.hpp"
#include "sim/grains/specimens/assembly.hpp"
#include "sim/grains/specimens/grading.hpp"
#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::sim::test {

inline Cloud small_cloud(int grains = 500) {
  return make_cloud(draw_diameters(paper_grading(), grains, 7), 8);
}

/// 500 grains at 100 kPa, compacted with 5°.
inline const Compacted& dense_specimen() {
  static const Compacted specimen = compact(small_cloud(), ContactLaw{}, Compaction{});
  return specimen;
}
/// The same, compacted with 25°.
inline const Compacted& loose_specimen() {
  static const Compacted specimen = [] {
    Compaction how;
    how.friction_angle = 0.4363;
    return compact(small_cloud(), ContactLaw{}, how);
  }();
  return specimen;
}

/// The dense one under σ₁ (Pa) and 100 kPa, at rest.
inline GrainState rested(const GrainState& from, double axial_pa) {
  Grains grains(from);
  grains.drive(triaxial_drives(stress_drive(axial_pa, 0.05), stress_drive(1e5, 0.05)));
  Settling how;
  how.unbalanced = 1e-5;
  how.stress_error_pa = 2;
  settle(grains, how);
  calm(grains);
  settle(grains, how);
  return grains.state();
}
inline const GrainState& calm_state() {
  static const GrainState state = rested(dense_specimen().state, 2e5);
  return state;
}
/// The same after a little unloading: hardly a contact is at its limit in any direction.
inline const GrainState& unloaded_state() {
  static const GrainState state = rested(calm_state(), 1.95e5);
  return state;
}

}  // namespace triax::sim::test
