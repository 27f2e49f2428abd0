// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/curve_labels.hpp"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "src/plot/plot_style.hpp"

namespace triax::src {
namespace {

/// Heights of the column of labels, px downwards: as near to those wanted, which rise, as a
/// distance between neighbours and the border allow.
std::vector<double> spread(std::vector<double> wanted, double distance, double border) {
  for (std::size_t i = 1; i < wanted.size(); ++i)
    wanted[i] = std::max(wanted[i], wanted[i - 1] + distance);
  for (std::size_t i = wanted.size(); i-- > 0; border -= distance)
    wanted[i] = std::min(wanted[i], border);
  return wanted;
}

class Labels {
 public:
  Labels(QCPAxisRect& rect, const std::vector<LabelledCurve>& curves)
      : rect_(rect), curves_(curves), order_(curves.size()) {
    rect.parentPlot()->replot();
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::stable_sort(order_, {}, [&](std::size_t i) { return pixel(curves_[i].top).y(); });
  }

  void draw() {
    if (curves_.empty()) return;
    std::vector<double> wanted;
    for (const std::size_t i : order_) wanted.push_back(pixel(curves_[i].top).y());
    const double height = std::ceil(metrics_.height()) + 2;
    const auto heights = spread(wanted, height, rect_.bottom() - height);
    const double x = column(heights);
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const LabelledCurve& curve = curves_[order_[k]];
      const QPointF at = coordinates({x, heights[k]});
      auto* leader =
          draw_curve(rect_, {curve.top, coordinates({x - kGap, heights[k]})}, line(kGrey, 0.7));
      lay_behind(*leader);
      write_text(rect_, at, curve.text, curve.colour, Qt::AlignLeft | Qt::AlignVCenter);
    }
  }

 private:
  static constexpr double kGap = 3;        // px between a line and its words
  static constexpr double kDistance = 24;  // px from the curves

  QPointF pixel(const QPointF& at) const {
    return {rect_.axis(QCPAxis::atBottom)->coordToPixel(at.x()),
            rect_.axis(QCPAxis::atLeft)->coordToPixel(at.y())};
  }
  QPointF coordinates(const QPointF& pixel) const {
    return {rect_.axis(QCPAxis::atBottom)->pixelToCoord(pixel.x()),
            rect_.axis(QCPAxis::atLeft)->pixelToCoord(pixel.y())};
  }

  /// The left of the column: to the right of every curve at its height and of every top.
  double column(const std::vector<double>& heights) const {
    const double clear = 0.7 * metrics_.height();
    double x = rect_.left(), widest = 0;
    for (const auto& [points, top, text, colour] : curves_) {
      x = std::max(x, pixel(top).x());
      widest = std::max(widest, metrics_.horizontalAdvance(QString::fromStdString(text)));
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const QPointF a = pixel(points[i]), b = pixel(points[i + 1]);
        const double low = std::min(a.y(), b.y()), high = std::max(a.y(), b.y());
        if (high > heights.front() - clear && low < heights.back() + clear)
          x = std::max({x, a.x(), b.x()});
      }
    }
    return std::min(x + kDistance, rect_.right() - widest - 2 * kGap);
  }

  QCPAxisRect& rect_;
  const std::vector<LabelledCurve>& curves_;
  std::vector<std::size_t> order_;
  QFontMetricsF metrics_{label_font()};
};

}  // namespace

void label_beside(QCPAxisRect& rect, const std::vector<LabelledCurve>& curves) {
  Labels(rect, curves).draw();
}

}  // namespace triax::src
