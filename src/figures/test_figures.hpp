#pragma once
#include <vector>

#include "src/figures/drawing.hpp"
#include "src/report/reported_test.hpp"

namespace triax::src {

/// The figures of one test in the order a report shows them: stress path, histories of shear,
/// histories around the onset; those without data are left out.
std::vector<Drawing> test_figures(const ReportedTest& test);

}  // namespace triax::src
