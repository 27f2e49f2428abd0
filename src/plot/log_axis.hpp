// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <qcustomplot.h>

namespace triax::src {

/// A logarithmic axis from below `low` to above `high`, both positive, never over less than a
/// factor of three, so that two ticks or more have a number: 1, 2, 5, 10 ... or closer, decades
/// where the axis is long.
void set_log_axis(QCPAxis& axis, double low, double high);

}  // namespace triax::src
