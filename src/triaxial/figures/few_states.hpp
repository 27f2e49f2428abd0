// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

/// Leaves of the curves of a test those states that drawings beside hundreds of other tests need:
/// in each plane that compares tests (q, u, ε_v and η over ε₁; q and e over p′) no state left out
/// lies farther than `part` of the extent of this test from the line through those kept. Those
/// nearest to the onset and to the loss of control stay. Work and forecasts, which no comparison
/// draws, go.
void keep_few_states(study::TestResult& test, double part = 1.0 / 1500);

}  // namespace triax::src
