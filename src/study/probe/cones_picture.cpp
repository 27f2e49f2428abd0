// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/cones_picture.hpp"

namespace triax::study {

std::vector<sim::Sector> sectors_of(const sim::Circle& circle) {
  std::vector<sim::Sector> sectors;
  for (const auto& cone : circle.cones) sectors.push_back({cone.from, cone.to});
  return sectors;
}

}  // namespace triax::study
