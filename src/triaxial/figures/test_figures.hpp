#pragma once
#include <vector>

#include "src/plot/drawing.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

/// The figures of one test in the order a report shows them: stress path, histories of shear,
/// histories around the onset; those without data are left out.
std::vector<Drawing> test_figures(const study::TestResult& test);

}  // namespace triax::src
