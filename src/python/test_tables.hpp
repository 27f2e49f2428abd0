// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

#include "db/store.hpp"
#include "src/python/columns.hpp"

namespace triax::python {

/// All states of a test under the names of the view `states` of the database. Signals are looked
/// for while they are read, here and below. Pre-condition: this thread does not hold the GIL.
Columns table_of_states(const db::Store& store, std::int64_t id);
/// The readings that the record holds, in units of the field, under its headings.
Columns table_of_readings(const db::Store& store, const db::StoredTest& test);
/// Second-order work along the measured path under the names of the table `work_points`.
Columns table_of_work(const db::Store& store, std::int64_t id);

}  // namespace triax::python
