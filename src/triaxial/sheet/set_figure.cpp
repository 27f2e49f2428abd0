// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/set_figure.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "src/study/triaxial/shear_series.hpp"
#include "src/triaxial/sheet/small_figure.hpp"

namespace triax::src {
namespace {

/// Value of the curve at x; nothing outside of it and where a sensor was faulty.
std::optional<double> value_at(const JoinedLine& curve, double x) {
  const Points& points = curve.points;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (curve.joins[i] == study::Join::none) continue;
    const auto &a = points[i - 1], &b = points[i];
    if ((a.x() - x) * (b.x() - x) > 0) continue;
    return b.x() == a.x() ? b.y() : a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x());
  }
  return std::nullopt;
}

/// What holds nine of ten curves at each x, and the median.
struct Band {
  Points low, middle, high;
};

Band band_of(const std::vector<JoinedLine>& curves) {
  constexpr int kSteps = 120;
  RangeOf x_range;
  for (const auto& curve : curves)
    for (const auto& p : curve.points) x_range.add(p.x());
  const auto range = x_range.with_margin(0, true);
  Band band;
  const auto known = static_cast<std::size_t>(std::ranges::count_if(
      curves, [](const JoinedLine& curve) { return curve.points.size() > 1; }));
  for (int i = 0; i <= kSteps; ++i) {
    // Closer at the beginning, where most of a test happens.
    const double share = static_cast<double>(i) / kSteps;
    const double x = range.lower + range.size() * share * share;
    std::vector<double> values;
    for (const auto& curve : curves)
      if (const auto value = value_at(curve, x)) values.push_back(*value);
    if (2 * values.size() < known) continue;  // of less than half of them no band
    std::ranges::sort(values);
    const auto part = [&](double of_all) {
      return values[static_cast<std::size_t>(
          std::lround(of_all * static_cast<double>(values.size() - 1)))];
    };
    band.low.emplace_back(x, part(0.05));
    band.middle.emplace_back(x, part(0.5));
    band.high.emplace_back(x, part(0.95));
  }
  return band;
}

OwnPlot band_figure(const std::vector<JoinedLine>& curves, const SheetAxis& x, const SheetAxis& y) {
  const auto band = band_of(curves);
  if (band.middle.size() < 2) return nullptr;
  SmallFigure figure(x.title, y.title);
  figure.take_in(band.low);
  figure.take_in(band.high);
  figure.take_in_zero(true, false);
  figure.fix_ranges();
  Points border = band.low;
  border.insert(border.end(), band.high.rbegin(), band.high.rend());
  auto fill = kBlue;
  fill.setAlpha(50);
  draw_area(*figure.plot().axisRect(), border, fill, Qt::NoPen);
  figure.curve(band.middle, line(kBlue, 1.8));
  return figure.take();
}

/// Shear of a test as a set draws it; empty where the plane has nothing to say of it.
JoinedLine curve_of_set(const SheetTest& test, const SheetAxis& x, const SheetAxis& y,
                        bool as_band) {
  const auto states = believed(test, true);
  const bool strains = y.title == volumetric_strain_axis().title;
  // Closed, its volume is the same by decree; of cycles there is no value at a strain.
  if (strains &&
      study::drainage_of_shear(test.result.stored.header, states) == lab::Drainage::closed)
    return {};
  if (as_band && test.result.stored.summary.cyclic) return {};
  const auto curve = line_in(test, states, x, y);
  return y.title == void_ratio_axis().title ? loaded(curve) : curve;
}

/// Each with its own pen; of many about sixty, thin.
template <class Curve>
void draw_curves(SmallFigure& figure, const std::vector<Curve>& curves) {
  const bool many = curves.size() > kMostCurves;
  for (const std::size_t i : drawn_of_many(curves.size()))
    figure.curve(curves[i], many ? line(QColor(0, 0x72, 0xB2, 70), 1) : curve_pen(i, 1.5));
}

}  // namespace

std::vector<std::size_t> drawn_of_many(std::size_t count) {
  constexpr double kMostDrawn = 60, kGolden = 0.6180339887498949;
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = kGolden * static_cast<double>(i);
    if (place - std::floor(place) < kMostDrawn / static_cast<double>(count)) drawn.push_back(i);
  }
  return drawn;
}

OwnPlot set_figure(const std::vector<const SheetTest*>& tests, const SheetAxis& x,
                   const SheetAxis& y) {
  const bool many = tests.size() > kMostCurves;
  const bool as_band = many && x.title == axial_strain_axis().title;
  std::vector<JoinedLine> curves;
  Points all;
  for (const auto* test : tests) {
    const auto& points = curves.emplace_back(curve_of_set(*test, x, y, as_band)).points;
    all.insert(all.end(), points.begin(), points.end());
  }
  if (all.size() < 2) return nullptr;
  if (as_band) return band_figure(curves, x, y);
  SmallFigure figure(x.title, y.title);
  figure.take_in(all);
  if (y.title == void_ratio_axis().title) {
    figure.widen_y(0.02);
    figure.fix_log_ranges(all);
  } else {
    figure.take_in_zero(true, false);
    figure.fix_ranges();
  }
  draw_curves(figure, curves);
  for (std::size_t i = 0; i < curves.size() && !many; ++i) {
    if (curves[i].points.empty()) continue;
    figure.marker(failure_in(*tests[i], x, y), failure_marker());
    figure.marker(onset_in(*tests[i], x, y), onset_ring());
    figure.marker(loss_of_control_in(*tests[i], x, y), loss_of_control_diamond());
  }
  return figure.take();
}

OwnPlot set_consolidation_figure(const std::vector<const SheetTest*>& tests) {
  std::vector<Points> curves;
  SmallFigure figure("√t (√min), consolidation", "water out (cm³)");
  for (const auto* test : tests) {
    const auto& curve = test->values.consolidation;
    figure.take_in(
        curves.emplace_back(curve && curve->in_m3 ? consolidation_points(*test) : Points{}));
  }
  if (figure.empty()) return nullptr;
  figure.take_in_zero(true, true);
  figure.fix_ranges();
  draw_curves(figure, curves);
  figure.plot().yAxis->setRangeReversed(true);  // as a settlement is drawn
  return figure.take();
}

}  // namespace triax::src
