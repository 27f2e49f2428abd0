// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A loose cloud of spheres, from which a specimen is compressed.
#include <cstdint>
#include <vector>

#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

struct Cloud {
  std::vector<Sphere> spheres;  ///< in the order of the diameters
  GrainBox box;                 ///< equal sides
};

/// Spheres at random places of a cube of which they fill `solid_share`, without overlap, the
/// largest placed first. The same seed gives the same cloud. Throws std::invalid_argument: no
/// diameter or one not above 0, a share out of 0 to 0.45, too few grains for that share.
Cloud make_cloud(const std::vector<double>& diameters_m, std::uint64_t seed,
                 double solid_share = 0.4);

}  // namespace triax::sim
