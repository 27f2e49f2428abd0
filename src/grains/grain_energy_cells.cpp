// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_energy_cells.hpp"

#include <cmath>

#include "src/output/words.hpp"

namespace triax::src {
namespace {

std::string known(double joule) { return std::isfinite(joule) ? in_joule(joule) : kUnknown; }

}  // namespace

Table energy_columns(const std::string& first, Align align) {
  Table table;
  table.columns.push_back({first, align});
  for (const char* heading : {"walls (J)", "elastic (J)", "kinetic (J)", "friction (J)",
                              "damping (J)", "stopped (J)", "error", "momentum"})
    table.columns.push_back({heading, Align::right});
  return table;
}

std::vector<std::string> energy_cells(const sim::GrainLedger& l) {
  return {known(l.walls_j),
          known(l.elastic_end_j - l.elastic_start_j),
          known(l.kinetic_end_j - l.kinetic_start_j),
          known(l.friction_j),
          known(l.damping_j),
          known(l.stopped_j),
          known(l.energy_error_share()),
          known(l.momentum_error())};
}

}  // namespace triax::src
