// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Invented tests with round numbers, for the tests of reports and figures.
#include "src/study/triaxial/test_result.hpp"

namespace triax::src::test {
using namespace triax::study;

/// Undrained, along time, recorded: q rises to 60 kPa at reading 300 (p′ = 100 kPa, 30 s, ε₁ = 0.5
/// %) and falls to 6 kPa at reading 900; kind flow, onset at the peak, M = 1.25.
TestResult flow_test();
/// The same as a simulation with truth, named "sim-26", programme CSU, seed 7.
TestResult simulated_test();
/// No time in the record, no collapse, q rises all along; nothing known of the specimen.
TestResult stable_test();
/// Cut off after some readings: no summary.
TestResult interrupted_test();

}  // namespace triax::src::test
