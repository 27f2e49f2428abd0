// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Results that a laboratory reported, in words.
#include <string>

#include "lab/ags/triaxial_results.hpp"

namespace triax::src {

/// "AGS4 results: no readings in it, nothing to judge; 3 triaxial results"
std::string what_it_is(const lab::AgsResults& file);
/// "22 U, 4.55 m"; empty where nothing is known, as below.
std::string sample_of(const lab::ReferenceSpecimen& specimen);
/// "1, 4.68 m"
std::string specimen_of(const lab::ReferenceSpecimen& specimen);

}  // namespace triax::src
