// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace triax::study {

/// t with P(|T| ≤ t) = confidence of Student's distribution: half the width of an interval, in
/// standard errors. Pre-condition: degrees ≥ 1.
double student_quantile(double degrees_of_freedom, double confidence);

}  // namespace triax::study
