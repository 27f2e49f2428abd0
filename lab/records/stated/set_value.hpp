// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Values that a user states about a record: --set, a job file, a correction of a stored test.
#include <optional>
#include <string>
#include <string_view>

#include "lab/results/record_header.hpp"

namespace triax::lab {

struct SetValue {
  std::string key;    ///< as in metadata_keys(): "specimen.height_mm"
  std::string value;  ///< as typed
  std::string where;  ///< for messages: "--set specimen.height_mm=140", "job.toml:7"
};

/// Sets the value. An assumption about a stage that the value answers is removed from
/// header.guesses, or loses this alternative. A stage whose drainage is set is marked as such.
/// Throws BadInput "WHERE: ..." as set_metadata(), and for test.origin and test.seed, which only
/// the record itself can state.
void set_value(RecordHeader& header, const SetValue& set);

/// The N of "stages.N.role"; empty for other keys.
std::optional<int> stage_of_key(std::string_view key);

}  // namespace triax::lab
