// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Proving rings and dial gauges: readings that are a force or a displacement times a factor.
#include <cstddef>
#include <optional>
#include <vector>

#include "lab/intake/proposal.hpp"

namespace triax::lab {

struct GaugeColumn {
  std::size_t column = 0;  ///< of Proposal::table, from 0
  bool is_force = false;   ///< else a displacement
  /// N or m per reading as written, with the sign; empty: the file does not have the factor.
  std::optional<double> scale;
};

/// The columns that are the only force or displacement of the file. The factor of a ring is a label
/// with a unit or a column that does not change. A dial has a unit of length, or divisions whose
/// length a label states.
std::vector<GaugeColumn> find_gauge_columns(const Proposal& proposal);

/// Gives a dial in divisions its factor (mm per division) if the file has the displacement that
/// follows from it in all rows.
void settle_dial_factor(Proposal& proposal);

}  // namespace triax::lab
