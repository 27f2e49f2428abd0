#pragma once
// Curves of several tests in one plane: one look a test, a common mark at the onset of collapse.
#include <qcustomplot.h>

#include <string>
#include <vector>

#include "src/plot/from_zero.hpp"
#include "src/plot/shapes.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::src {

/// A ring at each onset.
QCPScatterStyle onset_marker();

/// Entries of the legend: a curve a test, and the onset if any test has one.
void name_series(QCPAxisRect& rect, const std::vector<study::TestResult>& tests);

/// The curve of the test with this number, thinned to what the eye can see. Ranges of the axes must
/// be final.
void draw_series(QCPAxisRect& rect, const Points& points, std::size_t number);

/// "ICU 6, ICU 42 and ICU 7".
std::string names_of(const std::vector<study::TestResult>& tests);

/// All of them, for what is said of their origin.
std::vector<const study::TestResult*> pointers_to(const std::vector<study::TestResult>& tests);

}  // namespace triax::src
