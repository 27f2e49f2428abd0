// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Volume of the specimen in shear: what flows out, and what pore fluid and lines give way by.
#include <optional>

#include "lab/measured/pore_fluid.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// dε_v = dε_v, measured + c du with c of PoreFluid, fixed where shear begins. Without a pore
/// pressure the measured volume is the specimen's.
class SpecimenVolume {
 public:
  SpecimenVolume() = default;  ///< of a specimen without dimensions
  explicit SpecimenVolume(const SpecimenInfo& specimen);

  /// The next state of the test; `stage` may be null. In shear the state with the volumetric strain
  /// of the specimen, else the state itself. Pre-condition: complete(state).
  State with_fluid(const State& state, const StageInfo* stage);
  /// c of the shear under way; empty before shear or without a pore pressure.
  const std::optional<FluidCompliance>& compliance() const { return compliance_; }
  /// (1 − B)/B of the B check; empty without one.
  std::optional<double> give() const { return fluid_.give(); }
  /// ∫c du where that shear began.
  double strain_at_start() const { return at_start_; }

 private:
  std::optional<double> volume_m3_;
  PoreFluid fluid_;
  std::optional<FluidCompliance> compliance_;
  double at_start_ = 0;  ///< ∫c du where shear began
};

}  // namespace triax::lab
