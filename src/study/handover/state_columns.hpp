// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The states of a test as a table that is handed over: one row a scan, units in the headings.
#include <functional>
#include <string>
#include <vector>

#include "db/store.hpp"

namespace triax::study {

struct StateColumn {
  std::string name;     ///< in the view `states` of the database, and in Python: "q_kPa"
  std::string heading;  ///< where it is handed over: "deviator_stress_kPa"; empty: it is not
  /// In the unit of the name; NaN where it is not known.
  double (*value)(const lab::State& state);
};

/// Reading, time, stage, strains, void ratio, area, stresses, η and φ_mob.
const std::vector<StateColumn>& state_columns();

/// Those of them that have a heading.
const std::vector<StateColumn>& columns_handed_over();

/// The headings that columns_handed_over() has, then second-order work, normalised and its error.
std::vector<std::string> state_headings();

/// Row by row, NaN for what is not known: second-order work stands in the row of the reading at the
/// centre of its window.
void for_each_state_row(const db::Store& store, std::int64_t id,
                        const std::function<void(const std::vector<double>&)>& use);

/// The headings of the readings of a test and its rows: time_s where it has one, stage, channels.
std::vector<std::string> reading_headings(const lab::RecordHeader& header);
void for_each_reading_row(const db::Store& store, const db::StoredTest& test,
                          const std::function<void(const std::vector<double>&)>& use);

}  // namespace triax::study
