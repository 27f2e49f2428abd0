// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/simulated_head.hpp"

#include <fmt/format.h>

#include "src/output/table.hpp"

namespace triax::src {

std::string fact(const std::string& label, const std::string& value) {
  return value.empty() ? std::string() : fmt::format("  {:<12}{}\n", label, on_one_line(value));
}

std::string simulated_head(const std::string& title, const HeadOfMaterial& m) {
  const std::string line = on_one_line(fmt::format("{}, {} (simulated)", title, m.name));
  return line + '\n' + std::string(display_width(line), '=') + '\n' + fact("law", m.law) +
         fact("based on", m.based_on) + fact("source", m.source) + fact("range", m.range);
}

std::string simulated_head(const std::string& title, const lab::MaterialSet& material) {
  return simulated_head(
      title, HeadOfMaterial{material.name, material.law->title, material.material.based_on,
                            material.source, material.range});
}

}  // namespace triax::src
