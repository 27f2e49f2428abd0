// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/probe/sphere.hpp"

namespace triax::src {

std::string sphere_text(const study::SphereResult& result);
/// "stress of 1 kPa, 18 rings of 36 directions, by the rate at the state".
std::string sphere_probing_words(const study::SphereProbing& probing);

}  // namespace triax::src
