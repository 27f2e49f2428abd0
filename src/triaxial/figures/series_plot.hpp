// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Curves of several tests in one plane: one look a test, common marks at the two instants.
#include <qcustomplot.h>

#include <limits>
#include <string>
#include <vector>

#include "src/plot/from_zero.hpp"
#include "src/plot/shapes.hpp"
#include "src/study/triaxial/shear_series.hpp"
#include "src/triaxial/figures/joined_line.hpp"

namespace triax::src {

/// A ring at each onset of instability.
QCPScatterStyle onset_marker();
/// A diamond at each loss of control.
QCPScatterStyle loss_of_control_marker();

/// Of more tests than these the curves have one look and one entry of the legend, and only some are
/// named in words.
inline constexpr std::size_t kMostNamed = 12;

/// Entries of the legend: a curve a test, the onset and the loss of control if any test has one.
void name_series(QCPAxisRect& rect, const std::vector<study::SeriesTest>& tests);

/// What an axis shows of a state, in the unit of the axis; NaN where it is not known.
using StateValue = double (*)(const lab::State&);

/// States as points of a plane, in order, up to the first beyond `x_most` (what an axis would cut
/// off on a screen, an SVG shows); those not known in both are left out.
Points points_of(const std::vector<lab::State>& states, StateValue x, StateValue y,
                 double x_most = std::numeric_limits<double>::infinity());

/// The same points as the line of a test.
JoinedLine line_of(const study::SeriesTest& test, StateValue x, StateValue y,
                   double x_most = std::numeric_limits<double>::infinity());

/// The curve of the test with this number among `tests`, thinned to what the eye can see. Ranges of
/// the axes must be final.
void draw_series(QCPAxisRect& rect, const JoinedLine& line, std::size_t number, std::size_t tests);

/// "ICU 6, ICU 42 and ICU 7"; of many "ICU 6, ICU 42, ICU 7 and 147 others".
std::string names_of(const std::vector<study::SeriesTest>& tests);

/// p′ and q in the unit of their axes.
inline double p_kPa(const lab::State& state) { return state.p_eff * 1e-3; }
inline double q_kPa(const lab::State& state) { return state.q * 1e-3; }

}  // namespace triax::src
