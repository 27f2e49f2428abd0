// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/servo_search.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "lab/collapse/onset_interval.hpp"

namespace triax::lab {

double work_of_search(double q_scatter, double p_eff) {
  constexpr double kShear = 1.5;  // 3G over K of sand
  const double largest = StressSpan::kOf95 * std::numbers::sqrt2 * q_scatter;
  return largest * largest / (kShear * p_eff);
}

double end_of_search(const PathHistory& history, const StageStart& start, double turn,
                     double last) {
  constexpr double kTells = 10;                 // times its scatter a fall of u
  std::optional<double> compliance;             // times K/p′
  for (double end = turn; end < last; ++end) {  // NOLINT: exact
    const auto fit = stress_near(history, end, last);
    if (!fit) continue;
    const double fallen = start.pore_pressure - fit->pore_pressure;
    if (!compliance) compliance = std::log(start.p_eff / fit->p_eff) / fallen;
    const bool known = *compliance > 0 && fallen > kTells * fit->pore_scatter;
    const double of_trend = -fit->p_rate * fit->pore_rate * *compliance;
    if (known && of_trend > work_of_search(fit->q_scatter, fit->p_eff)) return end;
  }
  return last;
}

}  // namespace triax::lab
