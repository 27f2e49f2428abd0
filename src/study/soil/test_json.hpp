// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/study/json_parts.hpp"
#include "src/study/soil/test_points.hpp"

namespace triax::study {

/// {"value", "error", "low", "high", "tests"}
Json json_estimate(const Estimate& estimate);
/// One test of a soil.
Json test_json(const TestPoints& test);

}  // namespace triax::study
