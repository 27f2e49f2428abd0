#pragma once
#include <vector>

#include "db/store.hpp"
#include "src/figures/stress_increments_figure.hpp"

namespace triax::src {

/// What each test that collapsed was going through at its onset, in the order of `ids`: the
/// measured increment of lab/collapse/measured_increment.hpp. A test whose increment is not to be
/// had, or lost in the noise (45° or more), is left out. Each test's scans are visited once.
std::vector<CollapseIncrement> collapse_increments(const db::Store& store,
                                                   const std::vector<std::int64_t>& ids);

}  // namespace triax::src
