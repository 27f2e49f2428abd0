// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/soil/figures/trend_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/plot/note.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/point_labels.hpp"
#include "src/plot/shapes.hpp"

namespace triax::src {
namespace {

constexpr int kTrendWidth = 640, kTrendHeight = 460 + kNoteHeight;
constexpr int kLinePoints = 60;

struct Line {
  Points middle, low, high;
};

Line line_of(const study::Trend& trend, const TrendWords& words) {
  const auto& fit = trend.line;
  const double margin = 0.08 * (fit.x_high - fit.x_low);
  Line line;
  for (int i = 0; i <= kLinePoints; ++i) {
    const double x = fit.x_low - margin + (fit.x_high - fit.x_low + 2 * margin) * i / kLinePoints;
    const auto y = fit.line_at(x);
    line.middle.emplace_back(words.x_of(x), words.y_of(y.value));
    line.low.emplace_back(words.x_of(x), words.y_of(y.low));
    line.high.emplace_back(words.x_of(x), words.y_of(y.high));
  }
  return line;
}

Points places(const std::vector<study::FitPoint>& points, const TrendWords& words) {
  Points out;
  for (const auto& p : points) out.emplace_back(words.x_of(p.x), words.y_of(p.y));
  return out;
}

void set_ranges(QCustomPlot& plot, const Points& points, const Line& line, bool logarithmic) {
  RangeOf x, y;
  for (const auto* list : {&points, &line.middle})
    for (const auto& p : *list) x.add(logarithmic ? std::log10(p.x()) : p.x()), y.add(p.y());
  const double spread = y.width();
  // The band may be far wider than what was measured; it is cut where it would hide that.
  for (const auto* list : {&line.low, &line.high})
    for (const auto& p : *list)
      y.add(std::clamp(p.y(), line.middle.front().y() - 2 * spread,
                       line.middle.front().y() + 2 * spread));
  QCPRange range = x.with_margin(0.06, false);
  if (logarithmic) range = QCPRange(std::pow(10, range.lower), std::pow(10, range.upper));
  plot.xAxis->setRange(range);
  plot.yAxis->setRange(y.with_margin(0.08, false));
}

FigureData data_of(const study::Soil& soil, const study::Trend& trend, const TrendWords& words) {
  FigureData data{.title = words.caption,
                  .origin = std::ranges::all_of(soil.tests, &study::TestPoints::simulated)
                                ? "simulated"
                                : "recorded",
                  .remarks = {},
                  .columns = {{words.x_column, words.x_unit},
                              {words.y_column, words.y_unit},
                              {"left_out", ""},
                              {"test_id", ""}},
                  .rows = {}};
  const auto add = [&](const auto& points, const auto& tests, double left_out) {
    for (std::size_t i = 0; i < points.size(); ++i)
      data.rows.push_back({words.x_of(points[i].x), words.y_of(points[i].y), left_out,
                           static_cast<double>(soil.tests[tests[i]].id)});
  };
  add(trend.points, trend.tests, 0);
  add(trend.odd_points, trend.odd_tests, 1);
  return data;
}

}  // namespace

void make_logarithmic(QCPAxis& axis) {
  axis.setScaleType(QCPAxis::stLogarithmic);
  const auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  for (int power = -2; power < 6; ++power)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double at = digit * std::pow(10.0, power);
      ticker->addTick(at, QString::number(at));
    }
  axis.setTicker(ticker);
}

std::string soil_note(const study::Soil& soil) {
  const auto used = std::ranges::count_if(soil.tests, &study::TestPoints::used);
  const auto simulated =
      std::ranges::count_if(soil.tests, [](const auto& t) { return t.used && t.simulated; });
  return fmt::format("{}{} test{}, {}", soil.group.empty() ? "" : soil.group + ": ", used,
                     used == 1 ? "" : "s",
                     simulated == 0      ? "recorded"
                     : simulated == used ? "simulated"
                                         : fmt::format("{} of them simulated", simulated));
}

NamedFigure trend_figure(const study::Soil& soil, const study::Trend& trend,
                         const TrendWords& words) {
  auto plot = make_plot(kTrendWidth, kTrendHeight);
  auto& rect = *plot->axisRect();
  style_axes(rect, words.x_title, words.y_title);
  if (words.x_logarithmic) make_logarithmic(*plot->xAxis);
  const Points points = places(trend.points, words), odd = places(trend.odd_points, words);
  Points all = points;
  all.insert(all.end(), odd.begin(), odd.end());
  const Line line = line_of(trend, words);
  set_ranges(*plot, all, line, words.x_logarithmic);
  Points band = line.low;
  band.insert(band.end(), line.high.rbegin(), line.high.rend());
  draw_area(rect, band, QColor(0xD6, 0xE6, 0xF2), QPen(Qt::NoPen), "95 % interval of the line");
  draw_curve(rect, line.middle, src::line(kBlue, 1.8), "line through the tests");
  draw_markers(rect, points,
               QCPScatterStyle(QCPScatterStyle::ssCircle, src::line(kInk, 1.2), QBrush(kBlue), 7),
               "tests");
  if (!odd.empty())
    draw_markers(rect, odd,
                 QCPScatterStyle(QCPScatterStyle::ssCross, src::line(kVermilion, 2), QBrush(), 9),
                 "not used: does not fit the others");
  std::vector<PointLabel> labels;
  for (std::size_t i = 0; i < points.size(); ++i)
    labels.push_back({points[i].x(), points[i].y(), soil.tests[trend.tests[i]].name, kInk});
  for (std::size_t i = 0; i < odd.size(); ++i)
    labels.push_back({odd[i].x(), odd[i].y(), soil.tests[trend.odd_tests[i]].name, kVermilion});
  legend_below(*plot, 2);
  note_below(*plot, soil_note(soil));
  place_labels(*plot, labels);
  return {words.name, {std::move(plot), words.caption}, data_of(soil, trend, words)};
}

}  // namespace triax::src
