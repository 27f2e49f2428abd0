// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/scans/read_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "db/scans/scan_codec.hpp"
#include "lab/results/quantity.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::db {
namespace {

/// As decode() has it: what the detail says stands before what follows from the channel.
std::string pore_pressure_sql() {
  return fmt::format(
      "CASE WHEN d.state_missing >> {} & 1 THEN NULL "
      "ELSE coalesce(d.state_pore_pressure_Pa / 1000.0, s.{}) END",
      static_cast<int>(Derived::pore), lab::heading(lab::Quantity::pore_pressure));
}

std::vector<ReadColumn> make_columns() {
  std::vector<ReadColumn> columns = {
      {"time_s", "s.time_s"},
      {"stage", "s.stage"},
      {"axial_strain", "s.axial_strain"},
      {"volumetric_strain", "s.volumetric_strain"},
      {"q_kPa", "s.q_Pa / 1000.0"},
      {"p_eff_kPa", "s.p_eff_Pa / 1000.0"},
      {"pore_pressure_kPa", "s." + lab::heading(lab::Quantity::pore_pressure),
       pore_pressure_sql()}};
  for (const lab::QuantityInfo& row : lab::raw_channels())
    if (row.quantity != lab::Quantity::pore_pressure)
      columns.push_back({lab::heading(row.quantity), "s." + lab::heading(row.quantity)});
  return columns;
}

double stored(lab::Quantity channel, const lab::Reading& reading) {
  const double si = reading[channel];
  return std::isfinite(si) ? field_value(si, sim::find_unit(lab::info(channel).unit)->scale)
                           : lab::kMissing;
}

}  // namespace

std::span<const ReadColumn> read_columns() {
  static const std::vector<ReadColumn> columns = make_columns();
  return columns;
}

std::optional<std::size_t> find_read_column(std::string_view name) {
  const auto all = read_columns();
  const auto found = std::ranges::find(all, name, &ReadColumn::name);
  if (found == all.end()) return std::nullopt;
  return static_cast<std::size_t>(found - all.begin());
}

void fill_row(const lab::Reading& reading, const lab::State& state, std::vector<double>& row) {
  constexpr double kPa = 1000.0;
  const double pore = reading[lab::Quantity::pore_pressure];
  row = {state.time_s,
         static_cast<double>(state.stage),
         state.strain.axial,
         state.volumetric_strain,
         state.q / kPa,
         state.p_eff / kPa,
         pore == state.pore_pressure ? stored(lab::Quantity::pore_pressure, reading)
                                     : state.pore_pressure / kPa};
  for (const lab::QuantityInfo& channel : lab::raw_channels())
    if (channel.quantity != lab::Quantity::pore_pressure)
      row.push_back(stored(channel.quantity, reading));
}

}  // namespace triax::db
