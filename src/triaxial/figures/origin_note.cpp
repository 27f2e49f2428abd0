// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/origin_note.hpp"

#include <fmt/format.h>

namespace triax::src {
namespace {

/// Of more materials than these their number is told.
constexpr std::size_t kMostMaterials = 3;
constexpr std::size_t kMostTests = 8;

std::string few(const std::vector<std::string>& names) {
  if (names.size() <= kMostTests) return fmt::format("{}", fmt::join(names, ", "));
  return fmt::format("{} and {} others", fmt::join(names.begin(), names.begin() + kMostTests, ", "),
                     names.size() - kMostTests);
}

}  // namespace

std::string origin_note(const study::TestsOrigin& origin) {
  const auto& [tests, names, materials, cut] = origin;
  const std::string end =
      cut.empty() ? std::string()
                  : fmt::format("a sensor failed in {}: nothing after that is drawn", few(cut));
  if (names.empty()) return end;
  const bool all = origin.all_simulated();
  const std::string which = all ? "simulated" : "simulated: " + few(names);
  const std::string how = materials.size() > kMostMaterials
                              ? fmt::format("{} sets of parameters", materials.size())
                              : fmt::format("{}", fmt::join(materials, ", "));
  const std::string note = how.empty() ? which : which + (all ? ": " : ", with ") + how;
  return end.empty() ? note : note + ", " + end;
}

}  // namespace triax::src
