// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/channels.hpp"

#include <algorithm>
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

std::vector<std::string> without(std::span<const Quantity> columns,
                                 std::initializer_list<Quantity> wanted) {
  std::vector<std::string> lacking;
  for (const Quantity q : wanted)
    if (!has_all(columns, {q})) lacking.push_back(heading(q));
  return lacking;
}

/// q and p' follow.
bool has_both_stresses(std::span<const Quantity> columns) {
  return has_all(columns, {effective_axial_stress, effective_radial_stress}) ||
         has_all(columns, {deviator_stress, mean_effective_stress}) ||
         has_all(columns, {deviator_stress, effective_radial_stress}) ||
         has_all(columns, {deviator_stress, effective_axial_stress}) ||
         has_all(columns, {deviator_stress, stress_ratio}) ||
         has_all(columns, {mean_effective_stress, stress_ratio}) ||
         has_all(columns, {axial_stress, radial_stress, pore_pressure}) ||
         has_all(columns, {deviator_stress, radial_stress, pore_pressure}) ||
         has_all(columns, {deviator_stress, cell_pressure, pore_pressure});
}

/// q follows.
bool has_deviator(std::span<const Quantity> columns) {
  return has_all(columns, {deviator_stress}) || has_all(columns, {axial_stress, radial_stress}) ||
         has_all(columns, {axial_stress, cell_pressure}) || has_both_stresses(columns);
}

constexpr const char* kHeldPressure =
    "; a cell pressure that was held can be given with --set test.cell_pressure_kPa=...";
constexpr const char* kStressBeforeShear =
    "; excess_pore_pressure needs the stress before shear: cell_pressure and back_pressure as "
    "columns, labels above the table or values of a dialect, or a label of the effective "
    "consolidation stress";
constexpr const char* kTotalStress =
    "; a test in total stresses needs no effective stress: --set test.programme=UU, or UC if it "
    "is unconfined";

}  // namespace

bool may_be_total_stress(std::span<const Quantity> columns) {
  return has_all(columns, {axial_displacement, axial_force}) ||
         has_all(columns, {axial_strain, deviator_stress}) ||
         has_all(columns, {axial_strain, axial_stress});
}

std::string missing_channels(std::span<const Quantity> columns, bool total_stress) {
  const auto lacking = without(columns, {axial_displacement, axial_force, cell_pressure});
  if (lacking.empty()) return {};
  const bool stresses = total_stress ? has_deviator(columns) : has_both_stresses(columns);
  if (stresses && has_all(columns, {axial_strain})) return {};
  std::vector<std::string> there;
  for (const Quantity q : columns) there.push_back(heading(q));
  std::string text = fmt::format(
      "channels are missing: a raw record also needs {}; a reduced record needs axial_strain and "
      "two stresses, such as deviator_stress_kPa and mean_effective_stress_kPa; found: {}",
      joined(lacking), there.empty() ? "none" : joined(there));
  if (!may_be_total_stress(columns)) return text;
  if (!has_all(columns, {deviator_stress})) text += kHeldPressure;
  if (has_all(columns, {excess_pore_pressure}))
    text += kStressBeforeShear;
  else if (!total_stress)
    text += kTotalStress;
  return text;
}

}  // namespace triax::lab
