// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A packing of spheres as a text file, as other programs can write it:
//
//   N x0 x1 y0 y1 z0 z1        number of grains, the box, m
//   x y z radius               a line a grain, m
#include <string>
#include <string_view>
#include <vector>

#include "sim/grains/state/grain_state.hpp"

namespace triax::lab {

struct GrainPacking {
  std::vector<sim::Sphere> spheres;
  sim::GrainBox box;
};

/// `axis` (0 to 2) of the packing becomes the third one, the axis of the specimen; the others
/// follow in their cyclic order. Throws BadInput with file and line: not such a text, a number that
/// is not finite, a radius or an edge not above 0, a centre outside the box, more or fewer grains
/// than it says.
GrainPacking read_packing(std::string_view text, const std::string& file, int axis);
/// The same from a file of at most 1 GB.
GrainPacking load_packing(const std::string& path, int axis);

}  // namespace triax::lab
