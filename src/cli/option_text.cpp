// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/option_text.hpp"

#include <fmt/format.h>

namespace triax::src {

std::string describe_option(const CLI::Option& option) {
  const std::string value = option.get_default_str();
  return value.empty() ? option.get_description()
                       : fmt::format("{} [{}]", option.get_description(), value);
}

}  // namespace triax::src
