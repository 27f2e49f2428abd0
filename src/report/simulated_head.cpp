#include "src/report/simulated_head.hpp"

#include <fmt/format.h>

#include "src/output/table.hpp"

namespace triax::src {

std::string fact(const std::string& label, const std::string& value) {
  return value.empty() ? std::string() : fmt::format("  {:<12}{}\n", label, on_one_line(value));
}

std::string simulated_head(const std::string& title, const lab::MaterialSet& material) {
  const std::string line = on_one_line(fmt::format("{}, {} (simulated)", title, material.name));
  return line + '\n' + std::string(display_width(line), '=') + '\n' +
         fact("law", material.law->title) + fact("based on", material.material.based_on) +
         fact("source", material.source) + fact("range", material.range);
}

}  // namespace triax::src
