// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/python/columns.hpp"
#include "src/study/calibrate/calibration.hpp"

namespace triax::python {

/// A row a free parameter; error, low and high of one that is not determined are NaN.
Columns table_of_parameters(const study::Calibration& calibration);
/// A row an optimum: its cost, how many searches ended there, its values by their keys.
Columns table_of_optima(const study::Calibration& calibration);
/// A row a test that collapsed.
Columns table_of_predictions(const study::Calibration& calibration);
/// One test as it was measured, and as the calibrated law has it.
Columns table_of_curve(const study::MeasuredPath& measured, const study::ComputedPath& computed);

}  // namespace triax::python
