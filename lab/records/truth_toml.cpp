// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/truth_toml.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "sim/mechanics/units.hpp"

namespace triax::lab {
namespace {

// Keys of [truth] but the first, in the order in which they are written.
struct TruthKey {
  std::string_view name;
  std::string_view unit;
  std::optional<double> Truth::*member;
};
constexpr auto kTruthKeys =
    std::to_array<TruthKey>({{"time_s", "s", &Truth::time_s},
                             {"axial_strain", "", &Truth::axial_strain},
                             {"q_kPa", "kPa", &Truth::q_pa},
                             {"p_eff_kPa", "kPa", &Truth::p_eff_pa},
                             {"pore_pressure_kPa", "kPa", &Truth::pore_pressure_pa}});

// Keys of [[truth.run_aways]] in the same way.
struct RunAwayKey {
  std::string_view name;
  std::string_view unit;
  std::optional<double> RunAwayTruth::*member;
};
constexpr auto kRunAwayKeys =
    std::to_array<RunAwayKey>({{"kinetic_energy_J", "", &RunAwayTruth::kinetic_energy_j},
                               {"second_order_work_J", "", &RunAwayTruth::second_order_work_j},
                               {"expected_ratio", "", &RunAwayTruth::expected_ratio},
                               {"end_s", "s", &RunAwayTruth::end_s},
                               {"axial_strain", "", &RunAwayTruth::axial_strain},
                               {"q_kPa", "kPa", &RunAwayTruth::q_pa},
                               {"p_eff_kPa", "kPa", &RunAwayTruth::p_eff_pa},
                               {"pore_pressure_kPa", "kPa", &RunAwayTruth::pore_pressure_pa}});

// Finite in every unit.
constexpr Bounds kMeasurable{.at_least = -1e100, .at_most = 1e100};

RunAwayTruth read_run_away(const TomlTable& table) {
  RunAwayTruth found;
  found.start_s = table.required_number("start_s", kMeasurable);
  found.largest_kinetic_energy_j =
      table.required_number("largest_kinetic_energy_J", {.at_least = 0, .at_most = 1e100});
  found.largest_at_s =
      table.required_number("largest_at_s", {.at_least = found.start_s, .at_most = 1e100});
  for (const RunAwayKey& row : kRunAwayKeys)
    if (const auto value = table.number(row.name, kMeasurable))
      found.*row.member = sim::to_si(*value, *sim::find_unit(row.unit));
  if (found.end_s && *found.end_s < found.start_s) table.fail("end_s", "is before start_s");
  const auto ending = run_away_end_from(table.text("ending").value_or(""));
  if (!ending)
    table.fail("ending",
               fmt::format("is neither \"{}\" nor \"{}\"", to_string(RunAwayEnd::new_equilibrium),
                           to_string(RunAwayEnd::end_of_travel)));
  found.end = *ending;
  table.finish();
  return found;
}

void append(std::string& out, std::string_view key, const std::optional<double>& value) {
  if (value && std::isfinite(*value)) out += fmt::format("{} = {}\n", key, *value);
}

std::string run_away_toml(const RunAwayTruth& run_away) {
  std::string out = "[[truth.run_aways]]\n";
  append(out, "start_s", run_away.start_s);
  append(out, "largest_kinetic_energy_J", run_away.largest_kinetic_energy_j);
  append(out, "largest_at_s", run_away.largest_at_s);
  for (const RunAwayKey& row : kRunAwayKeys)
    if (const auto& si = run_away.*row.member)
      append(out, row.name, sim::to_field(*si, *sim::find_unit(row.unit)));
  if (run_away.end != RunAwayEnd::none)
    out += fmt::format("ending = {}\n", toml_quoted(to_string(run_away.end)));
  return out;
}

}  // namespace

Truth read_truth(const TomlTable& table) {
  Truth found;
  found.lost_sustainability = table.flag("lost_sustainability").value_or(false);
  for (const TruthKey& row : kTruthKeys)
    if (const auto value = table.number(row.name, kMeasurable))
      found.*row.member = sim::to_si(*value, *sim::find_unit(row.unit));
  for (const TomlTable& one : table.tables("run_aways"))
    found.run_aways.push_back(read_run_away(one));
  table.finish();
  return found;
}

std::string truth_toml(const Truth& truth) {
  std::string out = fmt::format("[truth]\nlost_sustainability = {}\n", truth.lost_sustainability);
  for (const TruthKey& row : kTruthKeys)
    if (const auto& si = truth.*row.member)
      append(out, row.name, sim::to_field(*si, *sim::find_unit(row.unit)));
  for (const RunAwayTruth& run_away : truth.run_aways) out += run_away_toml(run_away);
  return out;
}

}  // namespace triax::lab
