// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/plot/drawing.hpp"
#include "src/study/triaxial/stress_path.hpp"

namespace triax::src {

/// The effective stress path q over p′ of one test, with the onset of collapse, the instability
/// line q = η_coll p′ and the Mohr-Coulomb line q = M p′, each where it is known. No plot where the
/// test holds no stress at all.
Drawing stress_path_figure(const study::StressPath& path);

}  // namespace triax::src
