// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/calibrate/implied_domain.hpp"

namespace triax::src {

/// Cones and domain that a calibrated set implies, for a terminal.
std::string implied_domain_text(const study::ImpliedDomain& domain);

/// "e = 1.05, the median of the tests that collapsed".
std::string void_ratio_in_words(const study::ImpliedDomain& domain);

}  // namespace triax::src
