// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/channels.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <vector>

#include <fmt/format.h>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

using enum Quantity;

bool has_all(std::span<const Quantity> columns, std::initializer_list<Quantity> wanted) {
  return std::ranges::all_of(
      wanted, [&](Quantity q) { return std::ranges::find(columns, q) != columns.end(); });
}

}  // namespace

std::string missing_channels(std::span<const Quantity> columns) {
  constexpr std::array kRaw{axial_displacement, axial_force, cell_pressure};
  if (has_all(columns, {kRaw[0], kRaw[1], kRaw[2]})) return {};
  const bool stresses = has_all(columns, {effective_axial_stress, effective_radial_stress}) ||
                        has_all(columns, {deviator_stress, mean_effective_stress}) ||
                        has_all(columns, {deviator_stress, effective_radial_stress}) ||
                        has_all(columns, {deviator_stress, effective_axial_stress}) ||
                        has_all(columns, {deviator_stress, stress_ratio}) ||
                        has_all(columns, {mean_effective_stress, stress_ratio}) ||
                        has_all(columns, {axial_stress, radial_stress, pore_pressure}) ||
                        has_all(columns, {deviator_stress, radial_stress, pore_pressure}) ||
                        has_all(columns, {deviator_stress, cell_pressure, pore_pressure});
  if (stresses && has_all(columns, {axial_strain})) return {};
  std::vector<std::string> there;
  for (const Quantity q : columns) there.push_back(heading(q));
  std::vector<std::string> lacking;
  for (const Quantity q : kRaw)
    if (!has_all(columns, {q})) lacking.push_back(heading(q));
  return fmt::format(
      "channels are missing: a raw record also needs {}; a reduced record needs axial_strain and "
      "two stresses, such as deviator_stress_kPa and mean_effective_stress_kPa; found: {}",
      joined(lacking), there.empty() ? "none" : joined(there));
}

}  // namespace triax::lab
