// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Columns of a test for drawing, one number a scan, without decoding scan by scan: a test of a
// million scans is read in a third of a second.
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lab/results/reading.hpp"
#include "lab/results/state.hpp"

namespace triax::db {

/// A column that can be read, in units of the field.
struct ReadColumn {
  std::string name;  ///< "q_kPa", "axial_strain"; what is raw as in lab::heading()
  std::string sql;   ///< of scans s
  /// Of scans s and scan_details d where a test has details; empty: as `sql`.
  std::string sql_with_details{};
};

/// Time, stage, what was reduced (ε₁, ε_v, q, p′, u), then the raw channels but for u's own.
std::span<const ReadColumn> read_columns();
/// The place of that name in read_columns(); nothing where there is none.
std::optional<std::size_t> find_read_column(std::string_view name);

/// A scan as these columns, with the values that the database gives of it once it is stored.
void fill_row(const lab::Reading& reading, const lab::State& state, std::vector<double>& row);

}  // namespace triax::db
