// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Straight lines of the q-p′ plane.
#include <qcustomplot.h>

#include <string>
#include <vector>

namespace triax::src {

/// q = η p′ from the origin to the border of the axes, whose ranges must be final. p′, q in any one
/// unit.
void draw_instability_line(QCustomPlot& plot, double eta);
/// "η = 0.54"; of two "η = 0.54 in compression, -0.38 in extension". Pre-condition: not empty.
std::string instability_words(const std::vector<double>& etas);
/// q = M p′ + k, the Mohr-Coulomb limit surface in compression; k, which cohesion makes, in the
/// unit of q.
void draw_mohr_coulomb_line(QCustomPlot& plot, double limit_stress_ratio, double intercept = 0);
/// Without cohesion. One line each for limits in rising order; beyond two they are thin and have
/// one legend entry.
void draw_mohr_coulomb_lines(QCustomPlot& plot, const std::vector<double>& limit_stress_ratios);

}  // namespace triax::src
