// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A small programme for sweeps, and sweeps as the command line gives them.
#include <fstream>
#include <string>
#include <vector>

#include "lab/programmes/sweep.hpp"
#include "tests/lab/programmes/programme_text.hpp"

namespace triax::src::test {

inline lab::Sweep sweep_of(const std::vector<std::string>& texts) {
  std::vector<lab::SweepAxis> axes;
  for (const std::string& text : texts) axes.push_back(lab::read_sweep_axis(text));
  return lab::Sweep(axes);
}

inline std::string short_programme() { return lab::test::programme_text(); }

inline std::string short_programme_in(const std::string& path) {
  std::ofstream(path) << short_programme();
  return path;
}

}  // namespace triax::src::test
