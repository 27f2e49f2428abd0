// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <optional>

#include "lab/intake/meaning.hpp"
#include "lab/intake/table_columns.hpp"

namespace triax::lab {

/// The column, from 0, that is read as a time but falls back with each new stage and nowhere else:
/// a time within the stage, whatever its name.
std::optional<std::size_t> find_stage_time(const TableColumns& table, const Meaning& meaning);

/// The sample of that column with the name of a time within the stage.
ColumnSample stage_time_sample(ColumnSample sample, const ColumnReading& reading);

}  // namespace triax::lab
