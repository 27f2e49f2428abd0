// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "db/revisions.hpp"

namespace triax::study {

/// The result of a correction.
struct Corrected {
  std::int64_t revision = 0;  ///< of the test now; 0: no value changed, nothing is stored
  std::vector<db::RevisedValue> values;  ///< those that changed
};

/// Corrects values of a stored test, and reduces and assesses it again from its stored readings, as
/// a new revision under the same id. `values` are KEY, VALUE as of --set; an empty value is that of
/// revision 1. All of it is one transaction: whatever ends the process, the test has the old
/// revision or the new one. Values that are set back give the results of then, to the bit.
/// `on_part` receives the progress, 0 to 1.
///
/// Throws lab::BadInput for an unknown key or value, test.origin and test.seed, a stage that the
/// test does not have, and a test that is missing, runs, was interrupted or cannot be reduced with
/// these values; lab::WorkFailed for a database that cannot be written.
Corrected correct_test(const std::string& db, std::int64_t id,
                       const std::vector<std::pair<std::string, std::string>>& values,
                       const std::function<void(double)>& on_part = {});

}  // namespace triax::study
