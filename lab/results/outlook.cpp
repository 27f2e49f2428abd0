// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/outlook.hpp"

#include <array>

#include "lab/base/names.hpp"

namespace triax::lab {
namespace {

constexpr auto kWarningLevels = std::to_array<std::pair<WarningLevel, std::string_view>>(
    {{WarningLevel::none, "none"},
     {WarningLevel::approaching, "approaching"},
     {WarningLevel::imminent, "imminent"},
     {WarningLevel::lost, "lost"}});

}  // namespace

std::string_view to_string(WarningLevel level) {
  return name_of<WarningLevel>(level, kWarningLevels);
}
std::optional<WarningLevel> warning_level_from(std::string_view text) {
  return value_of<WarningLevel>(text, kWarningLevels);
}

}  // namespace triax::lab
