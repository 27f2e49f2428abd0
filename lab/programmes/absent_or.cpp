// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/absent_or.hpp"

#include <fmt/format.h>

#include "lab/base/toml_reader.hpp"

namespace triax::lab {

std::optional<double> absent_or(const TomlTable& table, const std::string& key, double smallest,
                                double largest) {
  const auto value = table.number(key);
  if (!value || *value == 0) return value;
  if (*value < smallest || *value > largest)
    table.fail(key, fmt::format("is {}, must be 0 or {:g} to {:g}", *value, smallest, largest));
  return value;
}

}  // namespace triax::lab
