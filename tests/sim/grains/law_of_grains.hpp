// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Grains in the place of a material point, made once each: 500 of them, dense and loose.
#include <memory>

#include "sim/grains/paths/grain_law.hpp"
#include "tests/sim/grains/specimens.hpp"

namespace triax::sim::test {

using LawOfGrains = std::shared_ptr<const GrainLaw>;
using GrainPoint = PointState<Axisymmetric>;
using GrainControl = MixedControl<Axisymmetric>;

inline LawOfGrains dense_grains() {
  static const auto law = std::make_shared<const GrainLaw>(dense_specimen().state);
  return law;
}
inline LawOfGrains loose_grains() {
  static const auto law = std::make_shared<const GrainLaw>(loose_specimen().state);
  return law;
}
/// 400 grains, compacted with 40°: undrained they have a low peak and liquefy.
inline LawOfGrains very_loose_grains() {
  static const auto law = [] {
    Compaction how;
    how.friction_angle = 0.6981317;
    how.unbalanced = 5e-4;
    how.pressure_share = 2e-3;
    return std::make_shared<const GrainLaw>(compact(small_cloud(400), ContactLaw{}, how).state);
  }();
  return law;
}
inline GrainPoint start_of(const GrainLaw& law) {
  return law.isotropic(law.pressure_pa(), law.void_ratio());
}
/// dq under dε_v = 0
inline GrainControl undrained_load(double dq_pa) {
  GrainControl control;
  control.stress.row(0) << 1, -1 / std::numbers::sqrt2;
  control.strain.row(1) << 1, std::numbers::sqrt2;
  control.increment << dq_pa, 0;
  return control;
}

}  // namespace triax::sim::test
