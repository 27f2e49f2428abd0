// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/origin_note.hpp"

#include <fmt/format.h>

namespace triax::src {
namespace {

/// Of more materials than these their number is told.
constexpr std::size_t kMostMaterials = 3;

}  // namespace

std::string origin_note(const study::TestsOrigin& origin) {
  const auto& [tests, names, materials] = origin;
  if (names.empty()) return {};
  const bool all = origin.all_simulated();
  const std::string which =
      all ? "simulated" : fmt::format("simulated: {}", fmt::join(names, ", "));
  const std::string how = materials.size() > kMostMaterials
                              ? fmt::format("{} sets of parameters", materials.size())
                              : fmt::format("{}", fmt::join(materials, ", "));
  return how.empty() ? which : which + (all ? ": " : ", with ") + how;
}

}  // namespace triax::src
