// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/number_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace triax::study {

std::string number_text(std::optional<double> value, int decimals) {
  if (!value || !std::isfinite(*value)) return "–";
  auto text = fmt::format("{:.{}f}", *value, decimals);
  // "-0.00" is a zero that carries the sign of a rounding error.
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

}  // namespace triax::study
