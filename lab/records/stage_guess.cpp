// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/stage_guess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace triax::lab {
namespace {

Guess::Said other_drainage(const StageInfo& stage) {
  return {fmt::format("stages.{}.drainage", stage.number),
          stage.drainage == Drainage::closed ? "open" : "closed"};
}

std::string said_otherwise(const StageInfo& stage) {
  const Guess::Said said = other_drainage(stage);
  return fmt::format("--set {}={}", said.key, said.value);
}

/// "the displacement by 4.2 mm": what changed from the first row to the last.
std::string movements(const StageSummary& moved) {
  struct Row {
    Quantity quantity;
    const char* name;
    double scale;
    const char* unit;
  };
  static constexpr auto kRows = std::to_array<Row>({
      {Quantity::axial_displacement, "the displacement", 1e3, "mm"},
      {Quantity::axial_force, "the force", 1e-3, "kN"},
      {Quantity::cell_pressure, "the cell pressure", 1e-3, "kPa"},
      {Quantity::pore_pressure, "the pore pressure", 1e-3, "kPa"},
      {Quantity::back_pressure, "the back pressure", 1e-3, "kPa"},
      {Quantity::back_volume, "the back volume", 1e9, "mm3"},
  });
  std::vector<std::string> parts;
  for (const Row& row : kRows)
    if (const double change = moved[row.quantity].change(); !std::isnan(change))
      parts.push_back(fmt::format("{} by {:.4g} {}", row.name, change * row.scale, row.unit));
  return parts.empty() ? "no measured quantity changed"
                       : fmt::format("changed: {}", fmt::join(parts, ", "));
}

constexpr double kMinDeviator_pa = 5e3;
constexpr double kConstant = 0.03, kMoves = 0.1;  ///< of the change of q
constexpr double kStands = 1e-4, kFlows = 1e-3;   ///< volumetric strain

double change_of_deviator(const StageSummary& shear, const SpecimenInfo& specimen) {
  const double reduced = shear.deviator.range();
  if (!std::isnan(reduced) || !specimen.diameter_m) return reduced;
  return shear[Quantity::axial_force].range() /
         (std::numbers::pi / 4 * *specimen.diameter_m * *specimen.diameter_m);
}

DrainageEvidence from_stresses(const StageSummary& shear, double deviator) {
  if (!(deviator >= kMinDeviator_pa)) return {};
  const double radial = shear.effective_radial.range();
  const double pore = shear[Quantity::pore_pressure].range();
  const double total = shear.total_radial.range();
  if (radial < kConstant * deviator && !(pore >= kConstant * deviator))
    return {Drainage::open, fmt::format("σ₃′ changes by {:.1f} kPa while q changes by {:.1f} kPa",
                                        radial / 1e3, deviator / 1e3)};
  if (pore > kMoves * deviator && total < kConstant * deviator)
    return {Drainage::closed,
            fmt::format("the pore pressure changes by {:.1f} kPa at a constant total radial stress",
                        pore / 1e3)};
  return {};
}

}  // namespace

Guess stage_guess(const StageSummary& moved, const StageInfo& inferred,
                  const SpecimenInfo& specimen) {
  std::string taken = inferred.role == StageRole::unknown ? "of unknown role"
                                                          : std::string(to_string(inferred.role));
  taken += fmt::format(", drainage {}", to_string(inferred.drainage));
  if (inferred.control != AxialControl::unknown)
    taken += fmt::format(", {} prescribed", to_string(inferred.control));
  std::string remedy =
      fmt::format("--set stages.{}.role=... and {}", inferred.number, said_otherwise(inferred));
  if (inferred.role == StageRole::shear && inferred.control == AxialControl::unknown) {
    taken += ", control of the axis unknown";
    remedy += fmt::format(" and --set stages.{}.control=displacement, load or constant_q",
                          inferred.number);
  }
  return {.what = fmt::format("stage {}", inferred.number),
          .taken = std::move(taken),
          .evidence = movements(moved),
          .remedy = std::move(remedy),
          .otherwise = other_answers(moved, inferred, specimen)};
}

void ask_other_drainage(Guess& guess, const StageInfo& inferred) {
  Guess::Said other = other_drainage(inferred);
  if (std::ranges::find(guess.otherwise, other.key, &Guess::Said::key) == guess.otherwise.end())
    guess.otherwise.push_back(std::move(other));
}

Guess drainage_guess(const StageInfo& inferred, const std::string& evidence) {
  return {.what = "drainage",
          .taken = std::string(to_string(inferred.drainage)),
          .evidence = evidence,
          .remedy = said_otherwise(inferred)};
}

Guess single_stage_guess(const StageInfo& only) {
  return {
      .what = "role",
      .taken = fmt::format("{} in all readings", to_string(only.role)),
      .evidence = "the record has no stage column",
      .remedy = fmt::format("a column `stage` if the record contains a B check or consolidation, "
                            "or --set stages.{}.role=...",
                            only.number)};
}

Guess split_guess(const std::vector<StageInfo>& stages, std::span<const std::int64_t> lines) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < stages.size(); ++i)
    all.push_back(fmt::format("{} ({}, drainage {}) from line {}", stages[i].number,
                              to_string(stages[i].role), to_string(stages[i].drainage), lines[i]));
  return {.what = "stages",
          .taken = fmt::format("{}", fmt::join(all, "; ")),
          .evidence = "the record has no stage column; load, pressures and volume show them",
          .remedy = "a column `stage`, or --set stages.NUMBER.role=... and drainage"};
}

DrainageEvidence find_drainage(const StageSummary& shear, const SpecimenInfo& specimen) {
  const double volume = shear[Quantity::volumetric_strain].range();
  const auto strain = fmt::format("its volumetric strain changes by {:.3g} %", volume * 100);
  if (volume > kFlows) return {Drainage::open, strain};
  if (auto found = from_stresses(shear, change_of_deviator(shear, specimen));
      found.drainage != Drainage::unknown)
    return found;
  if (volume <= kStands) return {Drainage::closed, strain};
  return {};
}

}  // namespace triax::lab
