// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the axes of a sheet's figures show, and the points of a test in such a plane.
#include <string>
#include <vector>

#include "src/plot/shapes.hpp"
#include "src/triaxial/figures/joined_line.hpp"
#include "src/triaxial/sheet/sheet_test.hpp"

namespace triax::src {

/// What an axis shows of a state; NaN where it is not known.
struct SheetAxis {
  std::string title;
  double (*value)(const lab::State&);
};
SheetAxis axial_strain_axis();
SheetAxis q_axis();
SheetAxis p_axis();
SheetAxis u_axis();
SheetAxis volumetric_strain_axis();
SheetAxis eta_axis();
SheetAxis void_ratio_axis();

/// The states of shear, or those before it, up to where a sensor failed.
std::vector<lab::State> believed(const SheetTest& test, bool shear);
/// The line through these states; a value that is not known is no gap unless a sensor was faulty.
JoinedLine line_in(const SheetTest& test, const std::vector<lab::State>& states, const SheetAxis& x,
                   const SheetAxis& y);
/// One point, or none.
Points failure_in(const SheetTest& test, const SheetAxis& x, const SheetAxis& y);
/// The state nearest to the onset: the onset itself lacks what figures show beside stresses.
Points onset_in(const SheetTest& test, const SheetAxis& x, const SheetAxis& y);
/// The state of the curves that is nearest to the loss of control.
Points loss_of_control_in(const SheetTest& test, const SheetAxis& x, const SheetAxis& y);
/// Outflow over √t (√min) of the consolidation: cm³, or % of ε_v where the record has no water;
/// none of fewer than three readings.
Points consolidation_points(const SheetTest& test);
/// Those with a logarithm that matters, of p′ in kPa.
JoinedLine loaded(const JoinedLine& line);

}  // namespace triax::src
