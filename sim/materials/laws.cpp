#include "sim/materials/laws.hpp"

#include <algorithm>

#include "sim/materials/sanisand.hpp"
#include "sim/materials/umat.hpp"

namespace triax::sim {

const std::vector<LawDescription>& laws() {
  static const std::vector<LawDescription> all = {
      sanisand_law(),
      umat_law(),
  };
  return all;
}

const LawDescription* find_law(std::string_view name) {
  const auto found = std::ranges::find(laws(), name, &LawDescription::name);
  return found == laws().end() ? nullptr : &*found;
}

}  // namespace triax::sim
