// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/base/byte_source.hpp"
#include "lab/records/findings.hpp"
#include "lab/records/table_layout.hpp"

namespace triax::lab {

/// Finds how the columns with times write dates and times of day, from their cells in the first and
/// last kClockRows rows, puts it into the layout and notes it as a finding, with the order of day
/// and month that is assumed. The last rows are not read if the first ones decide, or if they hold
/// plain numbers. A column of dates and one of times of day are left out if the record has a time
/// in numbers. Throws BadInput: a date that fits no format or not the order of the dialect,
/// a column of numbers without a unit of time.
void find_clocks(ByteSource& source, TableLayout& layout, Findings& findings);

inline constexpr std::size_t kClockRows = 1000;

}  // namespace triax::lab
