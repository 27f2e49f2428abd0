// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/test_figures.hpp"

#include <utility>

#include "src/triaxial/figures/history_figure.hpp"
#include "src/triaxial/figures/stress_path_figure.hpp"
#include "src/triaxial/figures/warning_figure.hpp"

namespace triax::src {

std::vector<TestFigure> test_figures(const study::TestResult& test) {
  std::vector<TestFigure> figures;
  figures.push_back({"stress_path", stress_path_figure(study::stress_path(test))});
  if (const auto shear = study::history(test, study::Span::shear))
    figures.push_back({"history", history_figure(*shear)});
  if (const auto onset = study::history(test, study::Span::onset))
    figures.push_back({"onset", history_figure(*onset)});
  if (const auto warnings = study::warning_history(test))
    figures.push_back({"alarm", warning_figure(*warnings)});
  std::erase_if(figures, [](const TestFigure& figure) { return !figure.drawing.plot; });
  return figures;
}

}  // namespace triax::src
