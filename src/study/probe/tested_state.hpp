// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The state of a stored test at one of its readings, as a law can be set to it.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/store.hpp"
#include "lab/measured/measured_increment.hpp"

namespace triax::study {

struct TestedState {
  std::int64_t id = 0;
  std::string name;
  lab::Origin origin = lab::Origin::recorded;
  std::string at;  ///< as asked: "collapse", "peak", "end" or the reading's number
  bool has_time = true;
  lab::State state;                                 ///< of that reading; its stresses are known
  std::optional<lab::MeasuredIncrement> increment;  ///< empty: not to be had there
  std::vector<std::string> warnings;
};

/// `test` is an id or a name; `at` is "collapse", "peak", "end" or the number of a reading.
/// `void_ratio` replaces that of the test. Throws lab::BadInput where there is no such test or
/// reading, or where its stresses or its void ratio are not known. "collapse" is the onset that the
/// verdict found; where strength was lost on the limit surface only, that onset, with a warning.
TestedState tested_state(const db::Store& store, const std::string& test, const std::string& at,
                         const std::optional<double>& void_ratio);

/// The same of several tests of the database in this file.
std::vector<TestedState> tested_states(const std::string& db, const std::vector<std::string>& tests,
                                       const std::string& at,
                                       const std::optional<double>& void_ratio);

}  // namespace triax::study
