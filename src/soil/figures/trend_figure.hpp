// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <qcustomplot.h>

#include <functional>
#include <string>

#include "src/plot/figure_files.hpp"
#include "src/study/soil/soil.hpp"

namespace triax::src {

/// What a trend is drawn as. Coordinates are those of the fit; `x_of`, `y_of` turn them into those
/// of the axes.
struct TrendWords {
  std::string name;  ///< of the files
  std::string x_title, y_title, x_column, y_column, x_unit, y_unit, caption;
  std::function<double(double)> x_of = [](double x) { return x; };
  std::function<double(double)> y_of = [](double y) { return y; };
  bool x_logarithmic = false;
};

/// Points with the names of their tests, the line with its 95 % interval, tests that were left out
/// as crosses.
NamedFigure trend_figure(const study::Soil& soil, const study::Trend& trend,
                         const TrendWords& words);

/// "sand: 12 tests, recorded", below a figure.
std::string soil_note(const study::Soil& soil);
/// A logarithmic axis with plain numbers.
void make_logarithmic(QCPAxis& axis);

}  // namespace triax::src
