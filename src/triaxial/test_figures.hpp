// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/plot/drawing.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

struct TestFigure {
  std::string name;  ///< "stress_path", "history", "onset", "alarm": of its files
  Drawing drawing;
};

/// The figures of one test, drawn from its curves, in the order a report shows them: stress path,
/// histories of shear, histories around the onset, forecasts of it; those without data are left
/// out.
std::vector<TestFigure> test_figures(const study::TestResult& test);

}  // namespace triax::src
