// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/facts/cyclic_fact.hpp"

#include <fmt/format.h>

namespace triax::src {
namespace {

std::string reached(const char* what, const std::optional<lab::CycleInstant>& at,
                    const std::string& most) {
  if (at) return fmt::format("{} in cycle {}, at reading {}", what, at->cycle, at->instant.reading);
  return fmt::format("{} not reached, maximum {}", what, most);
}

}  // namespace

std::vector<std::string> cyclic_lines(const lab::CyclicLoading& cyclic) {
  return {fmt::format(
              "{:g} cycles of q from {:.1f} to {:.1f} kPa, CSR = (q_max − q_min)/(4 p′₀) = {:.3f}",
              cyclic.cycles, cyclic.q_low_pa / 1e3, cyclic.q_high_pa / 1e3, cyclic.stress_ratio),
          reached("r_u = Δu/σ₃′₀ of 0.95", cyclic.liquefied,
                  fmt::format("{:.3g}", cyclic.largest_pore_pressure_ratio)),
          reached("double amplitude of 5 %", cyclic.double_amplitude,
                  fmt::format("{:.3g} %", cyclic.largest_double_amplitude * 100))};
}

}  // namespace triax::src
