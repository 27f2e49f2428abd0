// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/toml_number.hpp"

#include <fmt/format.h>

namespace triax::lab {

std::string toml_number(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";  // n: nan, inf
  return text;
}

}  // namespace triax::lab
