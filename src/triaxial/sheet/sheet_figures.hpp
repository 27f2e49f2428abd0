// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Small figures of a test report. In all of them a square is failure, a ring the onset of
// instability, a diamond the loss of control.
#include <QString>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/plot/drawing.hpp"
#include "src/plot/mohr_circles.hpp"
#include "src/sheet/sheet.hpp"
#include "src/triaxial/sheet/sheet_test.hpp"

namespace triax::src {

struct SheetFigure {
  std::string name;  ///< of its files: "eta"
  Drawing drawing;
};

/// The figures of one test, those without data left out: consolidation over the root of time; q, u
/// (drained: ε_v) and η over ε₁; stress path; e over log p′.
std::vector<SheetFigure> sheet_figures(const SheetTest& test);

/// Mohr circles that stay round on whatever place of a page.
SheetPart mohr_part(const std::vector<DrawnCircle>& circles,
                    const std::optional<DrawnEnvelope>& envelope, int width_px,
                    const QString& stress = "σ′ (kPa)");
/// That of failure; without a plot where there is none.
SheetPart circle_part(const SheetTest& test);

}  // namespace triax::src
