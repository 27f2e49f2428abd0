// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Small figures of a sheet. A square is failure, a ring the onset of collapse, in all of them.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/plot/drawing.hpp"
#include "src/plot/mohr_circles.hpp"
#include "src/sheet/sheet.hpp"
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

struct SheetFigure {
  std::string name;  ///< of its files: "eta"
  Drawing drawing;
};

/// The figures of one test, those without data left out: consolidation over the root of time; q, u
/// (drained: ε_v) and η over ε₁; stress path; e over log p′.
std::vector<SheetFigure> sheet_figures(const SheetTest& test);

/// Shear of several tests in one plane; of more than kMostCurves a band that holds nine of ten and
/// the median, at steps of x. Nothing without a point.
OwnPlot set_figure(const std::vector<const SheetTest*>& tests, const SheetAxis& x,
                   const SheetAxis& y);
inline constexpr std::size_t kMostCurves = 24;
/// Numbers of those of many curves or circles that are drawn in one plane: all of sixty, else about
/// sixty, in no step with the values of a sweep.
std::vector<std::size_t> drawn_of_many(std::size_t count);

/// Mohr circles that stay round on whatever place of a page.
SheetPart mohr_part(const std::vector<DrawnCircle>& circles,
                    const std::optional<DrawnEnvelope>& envelope, int width_px);
/// Its axes, where the circles are of total stresses.
void name_total_stress(QCustomPlot& plot);
/// q over ε₁ of tests of total stresses.
OwnPlot total_stress_figure(const std::vector<const SheetTest*>& tests);
/// That of failure; without a plot where there is none.
SheetPart circle_part(const SheetTest& test);

}  // namespace triax::src
