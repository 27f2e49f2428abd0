// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <vector>

#include "db/store.hpp"
#include "src/study/triaxial/collapse_increment.hpp"

namespace triax::study {

/// What each test that collapsed was going through when collapse set in, in the order of `ids`,
/// each file once (read_again.hpp), from the readings up to the onset: the measured increment of
/// lab/collapse/measured_increment.hpp; at held q, where pressure controllers go in steps, that
/// between the means of two spans of a twentieth of the stage. A test whose increment is not to be
/// had, or lost in the noise (45° or more), is left out.
std::vector<CollapseIncrement> collapse_increments(const db::Store& store,
                                                   const std::vector<std::int64_t>& ids);

}  // namespace triax::study
