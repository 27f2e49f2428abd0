#include "src/figures/point_labels.hpp"

#include <QFontMetricsF>
#include <array>

#include "src/figures/plot_style.hpp"

namespace triax::src {
namespace {

constexpr double kMarker = 12;  // px a marker takes

struct Side {
  double x, y;  // of the label's centre, in half label sizes from the point
};
constexpr std::array<Side, 8> kSides = {
    {{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {1, 1}, {-1, -1}, {-1, 1}}};

bool free_of(const QRectF& candidate, const std::vector<QRectF>& taken) {
  for (const auto& rect : taken)
    if (candidate.intersects(rect)) return false;
  return true;
}

void write(QCustomPlot& plot, const PointLabel& label, const QPointF& centre) {
  auto* text = new QCPItemText(&plot);
  text->setClipToAxisRect(false);
  text->setFont(label_font());
  text->setColor(label.colour);
  text->setText(QString::fromStdString(label.text));
  text->setPositionAlignment(Qt::AlignCenter);
  text->position->setType(QCPItemPosition::ptAbsolute);
  text->position->setCoords(centre);
}

}  // namespace

void place_labels(QCustomPlot& plot, const std::vector<PointLabel>& labels) {
  plot.replot();  // the layout gives pixels their meaning
  const QFontMetricsF metrics(label_font());
  std::vector<QRectF> taken;
  std::vector<QPointF> points;
  for (const auto& label : labels) {
    points.emplace_back(plot.xAxis->coordToPixel(label.x), plot.yAxis->coordToPixel(label.y));
    taken.emplace_back(points.back().x() - kMarker / 2, points.back().y() - kMarker / 2, kMarker,
                       kMarker);
  }
  const QRectF inside = plot.axisRect()->rect();
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double width = metrics.horizontalAdvance(QString::fromStdString(labels[i].text)) + 4;
    const double height = metrics.height();
    for (const auto& side : kSides) {
      const QPointF centre = points[i] + QPointF(side.x * (width + kMarker + 2) / 2,
                                                 side.y * (height + kMarker + 2) / 2);
      const QRectF rect(centre.x() - width / 2, centre.y() - height / 2, width, height);
      if (!inside.contains(rect) || !free_of(rect, taken)) continue;
      write(plot, labels[i], centre);
      taken.push_back(rect);
      break;
    }
  }
}

}  // namespace triax::src
