#include "src/triaxial/figures/series_plot.hpp"

#include <algorithm>

#include "src/plot/plot_style.hpp"
#include "src/plot/polyline.hpp"

namespace triax::src {

QCPScatterStyle onset_marker() {
  return {QCPScatterStyle::ssCircle, line(kVermilion, 1.6), QBrush(Qt::white), 8};
}

void name_series(QCPAxisRect& rect, const std::vector<study::TestResult>& tests) {
  for (std::size_t i = 0; i < tests.size(); ++i)
    draw_curve(rect, {}, curve_pen(i), tests[i].stored.header.name);
  if (std::any_of(tests.begin(), tests.end(),
                  [](const auto& test) { return study::collapse_onset(test.stored).has_value(); }))
    draw_markers(rect, {}, onset_marker(), "onset of collapse");
}

void draw_series(QCPAxisRect& rect, const Points& points, std::size_t number) {
  const double across = rect.width() / rect.axis(QCPAxis::atBottom)->range().size();
  const double up = rect.height() / rect.axis(QCPAxis::atLeft)->range().size();
  auto pixels = points;
  for (auto& point : pixels) point = {point.x() * across, point.y() * up};
  Points kept;
  for (const auto i : points_to_draw(pixels, kInvisible)) kept.push_back(points[i]);
  draw_curve(rect, kept, curve_pen(number));
}

std::string names_of(const std::vector<study::TestResult>& tests) {
  std::string names;
  for (std::size_t i = 0; i < tests.size(); ++i)
    names += (i == 0 ? "" : i + 1 == tests.size() ? " and " : ", ") + tests[i].stored.header.name;
  return names;
}

std::vector<const study::TestResult*> pointers_to(const std::vector<study::TestResult>& tests) {
  std::vector<const study::TestResult*> pointers;
  for (const auto& test : tests) pointers.push_back(&test);
  return pointers;
}

}  // namespace triax::src
