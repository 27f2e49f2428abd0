// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/row_json.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace triax::study {

void append_number(double value, std::string& json) {
  if (!std::isfinite(value)) {
    json += "null";
    return;
  }
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  json.append(digits.data(), end);
}

}  // namespace triax::study
