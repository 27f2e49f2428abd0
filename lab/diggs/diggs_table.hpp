// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The readings of a DIGGS test as rows of the CSV format of triax.
#include <string>
#include <vector>

#include "lab/diggs/diggs_columns.hpp"
#include "lab/diggs/diggs_document.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

struct DiggsTable {
  std::vector<DiggsColumn> columns;
  std::string rows;  ///< lines of cells in the units of the columns
  std::size_t count = 0;
  std::vector<Warning> warnings;  ///< what was left out or assumed, with lines of the file

  bool has(Quantity quantity) const;
  bool has_stages() const;
  /// Heading line and rows.
  std::string text() const;
};

/// The first set of results with two tuples or more, a strain or displacement, and a stress or
/// force; without rows where there is none. Numbers keep their digits and units, unless a record
/// does not know the unit. Throws BadInput with the line for
/// numbers that are none, and units that are unknown or of another kind.
DiggsTable read_result_sets(const DiggsTest& test, const std::string& file);

/// The shearing increments of a trial; without rows where it has none. A pore pressure that is
/// induced is added to the one at the start of shear, where the file has it. A cell pressure that
/// is given for the whole stage, or for earlier increments only, holds for the others.
DiggsTable read_increments(const DiggsTrial& trial, const std::string& file);

}  // namespace triax::lab
