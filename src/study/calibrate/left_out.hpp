// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The prediction that matters: η at the collapse of a test, from all the others.
#include <functional>
#include <vector>

#include "src/study/calibrate/calibration.hpp"

namespace triax::study {

/// Of each test that collapsed, if there are others: least squares on those from x, then the law
/// along the control of the test left out. The interval (90 %) is for the measured value: it adds
/// the errors of the parameters, of the measurement, and what the predictions of the other tests
/// scatter beyond these. `go_on` is told the share that is done and stops by false.
std::vector<Prediction> predict_left_out(const Misfit& misfit, const Unknowns& x,
                                         double void_ratio_error,
                                         const std::function<bool(double)>& go_on);

}  // namespace triax::study
