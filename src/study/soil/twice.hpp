// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "src/study/soil/sheared_test.hpp"
#include "src/study/soil/test_points.hpp"

namespace triax::study {

/// Of tests from one file, or with the same states to the bit, the latest that is complete counts;
/// the others are marked as not used, with the reason. Pre-condition: both lists are of the same
/// tests in the same order.
void leave_out_twice(const std::vector<ShearedTest>& tests, std::vector<TestPoints>& points);

}  // namespace triax::study
