#include "src/triaxial/figures/test_figures.hpp"

#include <utility>

#include "src/triaxial/figures/history_figure.hpp"
#include "src/triaxial/figures/stress_path_figure.hpp"

namespace triax::src {

std::vector<Drawing> test_figures(const study::TestResult& test) {
  std::vector<Drawing> figures;
  figures.push_back(stress_path_figure(test));
  figures.push_back(history_figure(test, Span::shear));
  figures.push_back(history_figure(test, Span::onset));
  std::erase_if(figures, [](const Drawing& drawing) { return !drawing.plot; });
  return figures;
}

}  // namespace triax::src
