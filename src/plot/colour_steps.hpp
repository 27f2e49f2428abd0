// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <qcustomplot.h>

#include <vector>

namespace triax::src {

/// `count` colours: those of the smooth scale through `stops` (equally spaced) at the middles of so
/// many equal steps.
std::vector<QColor> steps_between(const std::vector<QColor>& stops, int count);

/// A gradient of one colour a step, all steps equally long; what is not a number is light grey. The
/// steps end exactly where the range is divided, which QCustomPlot's own levels do not.
QCPColorGradient stepped_gradient(const std::vector<QColor>& steps);

/// Light grey of what has no value.
inline const QColor kNoValue{0xC9, 0xC9, 0xC9};

}  // namespace triax::src
