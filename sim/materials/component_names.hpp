// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "sim/mechanics/space.hpp"

namespace triax::sim {

/// Appends the names of a tensor that a memory holds as a Vector: "alpha_axial",
/// "alpha_radial_root2", or "alpha_11", ..., "alpha_12_root2". What a name with _root2 holds is √2
/// times the component (Mandel, sim/mechanics/space.hpp).
template <class Space>
void name_components(const std::string& tensor, std::vector<std::string>& names) {
  static constexpr std::array<const char*, 6> kTensor{"_11",       "_22",       "_33",
                                                      "_12_root2", "_13_root2", "_23_root2"};
  static constexpr std::array<const char*, 2> kTriaxial{"_axial", "_radial_root2"};
  if constexpr (Space::kSize == 2)
    for (const char* part : kTriaxial) names.push_back(tensor + part);
  else
    for (const char* part : kTensor) names.push_back(tensor + part);
}

}  // namespace triax::sim
