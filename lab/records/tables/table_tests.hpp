// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The tests of a table that holds several: side by side, below each other, or named by a column.
#include <optional>
#include <vector>

#include "lab/base/byte_source.hpp"
#include "lab/intake/text/table_sample.hpp"
#include "lab/records/dialect.hpp"
#include "lab/records/table_layout.hpp"

namespace triax::lab {

enum class Extent {
  sample,  ///< the rows after the first and last 1,000 lines only if a test begins in those
  whole,   ///< all rows
};

/// The tests in their order; empty if there is one, or if the table is not recognised, which
/// recognise_table() reports. Rows that begin another test are those of TestRestart. Throws
/// SeveralTests for a table with more than kMaxTests or
/// kMaxTables.
std::vector<TableTest> find_tests(ByteSource& source, const std::optional<Dialect>& forced,
                                  Extent extent = Extent::sample);
/// The same with read_sample() of the source.
std::vector<TableTest> find_tests(ByteSource& source, const TableSample& sample,
                                  const std::optional<Dialect>& forced, Extent extent);

inline constexpr std::size_t kMaxTests = 500;   ///< below each other
inline constexpr std::size_t kMaxTables = 100;  ///< side by side

}  // namespace triax::lab
