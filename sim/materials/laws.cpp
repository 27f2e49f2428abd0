// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/laws.hpp"

#include <algorithm>

#include "sim/materials/cam_clay.hpp"
#include "sim/materials/drucker_prager.hpp"
#include "sim/materials/elastic.hpp"
#include "sim/materials/hypoplastic.hpp"
#include "sim/materials/interpolated.hpp"
#include "sim/materials/mohr_coulomb.hpp"
#include "sim/materials/norsand.hpp"
#include "sim/materials/sanisand.hpp"
#include "sim/materials/umat.hpp"

namespace triax::sim {

const std::vector<LawDescription>& laws() {
  // A law that is built on another's sets comes after it.
  // clang-format off: one a line
  static const std::vector<LawDescription> all = {
      elastic_law(),  mohr_coulomb_law(), drucker_prager_law(), cam_clay_law(),   hypoplastic_law(),
      sanisand_law(), norsand_law(),      inl2_law(),           octolinear_law(), umat_law(),
  };
  // clang-format on
  return all;
}

const LawDescription* find_law(std::string_view name) {
  const auto found = std::ranges::find(laws(), name, &LawDescription::name);
  return found == laws().end() ? nullptr : &*found;
}

}  // namespace triax::sim
