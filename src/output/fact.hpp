// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

namespace triax::src {

/// A label and what is known about it; several lines for a list.
struct Fact {
  std::string label;
  std::vector<std::string> lines;
};

}  // namespace triax::src
