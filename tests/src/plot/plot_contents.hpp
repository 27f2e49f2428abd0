// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a plot holds, for tests of figures.
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "src/plot/drawing.hpp"
#include "tests/src/contains.hpp"

namespace triax::src::test {

inline std::vector<QCPCurve*> curves_of(const QCustomPlot& plot) {
  std::vector<QCPCurve*> curves;
  for (int i = 0; i < plot.plottableCount(); ++i)
    if (auto* curve = qobject_cast<QCPCurve*>(const_cast<QCustomPlot&>(plot).plottable(i)))
      curves.push_back(curve);
  return curves;
}

/// Curves with points that have this colour and, if given, this style of line.
inline std::vector<QCPCurve*> curves_in(const QCustomPlot& plot, const QColor& colour) {
  auto curves = curves_of(plot);
  std::erase_if(curves, [&](const QCPCurve* curve) {
    return curve->dataCount() == 0 || curve->lineStyle() == QCPCurve::lsNone ||
           curve->pen().style() == Qt::NoPen || curve->pen().color() != colour;
  });
  return curves;
}

inline bool has_point(const QCPCurve& curve, double x, double y, double tolerance) {
  return std::any_of(curve.data()->constBegin(), curve.data()->constEnd(), [&](const auto& point) {
    return std::abs(point.key - x) < tolerance && std::abs(point.value - y) < tolerance;
  });
}

inline bool any_has_point(const QCustomPlot& plot, double x, double y, double tolerance) {
  const auto curves = curves_of(plot);
  return std::ranges::any_of(
      curves, [&](const QCPCurve* curve) { return has_point(*curve, x, y, tolerance); });
}

inline std::vector<std::string> legend_of(const QCustomPlot& plot) {
  std::vector<std::string> names;
  for (int i = 0; i < plot.legend->itemCount(); ++i)
    if (auto* item = qobject_cast<QCPPlottableLegendItem*>(plot.legend->item(i)))
      names.push_back(item->plottable()->name().toStdString());
  return names;
}

inline bool in_legend(const QCustomPlot& plot, const std::string& part) {
  return std::ranges::any_of(legend_of(plot), [&](const std::string& name) {
    return name.find(part) != std::string::npos;
  });
}

/// Words written in a plot, whatever they stand beside.
inline std::vector<QCPItemText*> words_of(const QCustomPlot& plot) {
  std::vector<QCPItemText*> words;
  for (int i = 0; i < plot.itemCount(); ++i)
    if (auto* text = qobject_cast<QCPItemText*>(plot.item(i))) words.push_back(text);
  return words;
}

inline QRectF place_of(const QCPItemText& text) {
  return {text.topLeft->pixelPosition(), text.bottomRight->pixelPosition()};
}

/// No word covers another or is cut off by the border of the plot.
inline bool words_are_readable(QCustomPlot& plot) {
  plot.replot();
  const auto words = words_of(plot);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto place = place_of(*words[i]);
    if (!QRectF(plot.rect()).contains(place)) return false;
    for (std::size_t k = 0; k < i; ++k)
      if (place.intersects(place_of(*words[k]))) return false;
  }
  return true;
}

}  // namespace triax::src::test
