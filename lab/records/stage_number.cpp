// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/stage_number.hpp"

#include <cmath>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"

namespace triax::lab {

int StageNumbers::of(double value, std::int64_t line, Findings& findings) {
  constexpr double kLargest = 1e6;
  const bool fits = value >= 0 && value <= kLargest;
  const double tenfold = std::round(10 * value);
  const bool whole = fits && value == std::floor(value);
  if (!whole && (!fits || std::abs(10 * value - tenfold) > 1e-6))
    throw BadInput(file_, line, fmt::format("{} is not a stage number", value));
  const int number = static_cast<int>(whole ? value : tenfold);
  const double other = seen_.try_emplace(number, value).first->second;
  if (other != value)
    throw BadInput(file_, line,
                   fmt::format("stage {} would get the number {}, which stage {} has already; give "
                               "one of them another number",
                               value, number, other));
  if (!whole)
    findings.note("stage number", line,
                  fmt::format("stage {} is renumbered as stage {}", value, number));
  return number;
}

}  // namespace triax::lab
