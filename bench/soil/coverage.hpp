// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How often the intervals of `triax soil` hold what is true of the virtual sand.
#include <map>
#include <string>
#include <vector>

#include "bench/soil/campaign.hpp"
#include "src/study/soil/soil.hpp"

namespace triax::bench {

struct Covered {
  std::string what;
  bool held = false;
  double error = 0;       ///< value − truth
  double half_width = 0;  ///< of the interval
};

/// Every value that the study gives and the truth knows.
std::vector<Covered> covered(const Campaign& campaign, const study::Soil& soil);

struct Count {
  int held = 0, all = 0;
  double squares = 0;  ///< of the errors
  std::vector<double> half_widths;
  void add(const Covered& one);
  double share() const { return all > 0 ? static_cast<double>(held) / all : 0; }
};
using Counts = std::map<std::string, Count>;

/// True where the study names the test as odd.
bool names(const study::Soil& soil, const std::string& test);

}  // namespace triax::bench
