// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "db/store.hpp"
#include "lab/measured/measured_increment.hpp"
#include "src/study/triaxial/collapse_increment.hpp"

namespace triax::study {

/// What a test was going through when collapse set in at reading `onset`: by displacement from the
/// readings on both sides, else from those up to there, for what follows may be a fall within one
/// reading, which says nothing of how it came to it. At held q, where pressure controllers go in
/// steps, the increment is that between the means of two spans of a twentieth of the stage. Empty
/// where it is not to be had.
std::optional<lab::MeasuredIncrement> increment_towards(const db::Store& store,
                                                        const db::StoredTest& test,
                                                        std::int64_t onset);

/// That of each test that collapsed, in the order of `ids`, each file once (read_again.hpp). A test
/// whose increment is not to be had, or lost in the noise (45° or more), is left out.
std::vector<CollapseIncrement> collapse_increments(const db::Store& store,
                                                   const std::vector<std::int64_t>& ids);

}  // namespace triax::study
