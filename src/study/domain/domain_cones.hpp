// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the figures of cones of a domain show (Fig. 12 of the paper).
#include <vector>

#include "src/study/domain/domain_report.hpp"
#include "src/study/probe/cones_picture.hpp"

namespace triax::study {

/// Fans that a figure of cones holds along each axis and can still be read.
inline constexpr int kMostFans = 12;

/// Cones at some states, evenly spread, the boundaries of both sides, and the measured increments
/// of tests on top. Pre-condition: the domain is one of the axisymmetric plane.
ConesPicture cones_picture(const ReportedDomain& domain, const std::vector<TestedState>& tests);

}  // namespace triax::study
