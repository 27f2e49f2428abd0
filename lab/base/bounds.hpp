// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace triax::lab {

/// No pressure of a programme or a path is above 100 MPa.
inline constexpr double kLargestPressure_kPa = 1e5;

}  // namespace triax::lab
