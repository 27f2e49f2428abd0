// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <memory>

#include "bench/soil/campaign.hpp"
#include "sim/law/law.hpp"

namespace triax::bench {

/// What makes one specimen differ from the sand's mean.
struct Specimen {
  double void_ratio_shift = 0;  ///< of its critical state line
  double friction_factor = 1;   ///< of M, or of the strength
  bool undrained = false;
};

using LawPointer = std::shared_ptr<const sim::Law<sim::Axisymmetric>>;

struct VirtualSand {
  SoilTruth truth;  ///< without onset
  std::function<LawPointer(const Specimen&)> law;
};

/// Parameters drawn around those of real sands.
VirtualSand draw_sand(Sand sand, std::uint64_t seed);

}  // namespace triax::bench
