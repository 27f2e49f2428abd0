// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The rig with a specimen from sim/ instead of instruments on a bench. Time is number × interval.
#include <cstdint>
#include <memory>
#include <optional>

#include "lab/programmes/programme.hpp"
#include "lab/rig/rig_software.hpp"
#include "lab/rig/simulated/virtual_apparatus.hpp"

namespace triax::lab {

class VirtualRig : public RigSoftware {
 public:
  /// `seed` replaces the programme's own. Throws BadInput if the programme was built by hand with
  /// values that its reader would refuse. A state that the law cannot describe ends the test, or
  /// next() throws WorkFailed before the second reading.
  explicit VirtualRig(const Programme& programme, std::optional<std::uint64_t> seed = {});

  /// True state of the specimen at the last reading, which no instrument sees.
  const sim::SpecimenState& specimen_state() const { return plant().state().specimen; }
  /// The physical side, at the end of the last tick: for balances of energy and water.
  const Plant& plant() const;

 private:
  VirtualRig(const Programme& given, const GuardedProgramme& used, std::uint64_t seed);
};

}  // namespace triax::lab
