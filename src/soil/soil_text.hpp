// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/study/soil/soil.hpp"

namespace triax::src {

/// A soil for people: values with intervals, a table of tests, notes.
std::string soil_text(const study::Soil& soil);
/// "1.332  (1.310 to 1.354)" with so many decimals.
std::string with_interval(const study::Estimate& estimate, int decimals);

}  // namespace triax::src
