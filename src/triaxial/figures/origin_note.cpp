#include "src/triaxial/figures/origin_note.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace triax::src {
namespace {

/// Of more materials than these their number is told.
constexpr std::size_t kMostMaterials = 3;

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
    names.push_back(name);
}

}  // namespace

std::string origin_of(const std::vector<const study::TestResult*>& tests) {
  std::vector<std::string> names, materials;
  for (const auto* test : tests) {
    const auto& header = test->stored.header;
    if (header.origin != lab::Origin::simulated) continue;
    names.push_back(header.name);
    add_once(materials, header.specimen.material);
  }
  if (names.empty()) return {};
  const std::string which = names.size() == tests.size()
                                ? "simulated"
                                : fmt::format("simulated: {}", fmt::join(names, ", "));
  const std::string how = materials.size() > kMostMaterials
                              ? fmt::format("{} sets of parameters", materials.size())
                              : fmt::format("{}", fmt::join(materials, ", "));
  return how.empty() ? which : which + (names.size() == tests.size() ? ": " : ", with ") + how;
}

}  // namespace triax::src
