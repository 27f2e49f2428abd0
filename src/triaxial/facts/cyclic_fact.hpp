// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "lab/results/summary.hpp"

namespace triax::src {

/// "12 cycles of q from -20.1 to 24.6 kPa, CSR = ... = 0.149"; "r_u = Δu/σ₃′₀ of 0.95 in cycle 9,
/// at reading 712", or what it came to at most; the same of the double amplitude of 5 %.
std::vector<std::string> cyclic_lines(const lab::CyclicLoading& cyclic);

}  // namespace triax::src
