// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The stored tests that a calibration stands on, as paths.
#include <cstdint>
#include <vector>

#include "db/store.hpp"
#include "src/study/calibrate/measured_path.hpp"

namespace triax::study {

/// One test. The control that was applied is that of its stages: a closed drainage is driven
/// undrained, constant q as a stress path (up to the onset of collapse, where it can be held no
/// longer), everything else by axial strain at the measured radial stress. Throws lab::BadInput,
/// one line that names the test: no void ratio, no shear, no change of volume where the drainage is
/// open, cyclic loading, values that no soil has and whose unit is in doubt.
MeasuredPath path_of_test(const db::Store& store, std::int64_t id, const PathOptions& options = {});

/// Several tests, each file once. Throws lab::BadInput as above, and where they are of more than
/// one material, as their records (of simulated ones: their laws) call it.
std::vector<MeasuredPath> paths_of_tests(const db::Store& store,
                                         const std::vector<std::int64_t>& ids,
                                         const PathOptions& options = {});

/// Throws lab::BadInput where so many unknowns are more than these tests can tell: each gives four
/// numbers at most (a stiffness, a strength, and of both how they go on).
void check_enough(std::size_t unknowns, const std::vector<MeasuredPath>& paths);

}  // namespace triax::study
