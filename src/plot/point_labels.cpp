// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/point_labels.hpp"

#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "src/plot/plot_style.hpp"

namespace triax::src {
namespace {

constexpr double kMarker = 12;        // px a marker takes
constexpr double kLineStep = 4;       // px between the points that stand for a line
constexpr double kLongestLine = 1e5;  // px; beyond it the points stand farther apart
constexpr std::ptrdiff_t kMuch = 4;   // points of lines under a text: it is put farther off
constexpr std::array<double, 2> kFarther = {8, 16};  // px

struct Side {
  double x, y;  // of the label's centre, in half label sizes from the point
};
constexpr std::array<Side, 16> kSides = {{{1, 0},
                                          {-1, 0},
                                          {0, -1},
                                          {0, 1},
                                          {1, -1},
                                          {1, 1},
                                          {-1, -1},
                                          {-1, 1},
                                          {1, -0.6},
                                          {1, 0.6},
                                          {-1, -0.6},
                                          {-1, 0.6},
                                          {0.5, -1},
                                          {0.5, 1},
                                          {-0.5, -1},
                                          {-0.5, 1}}};

bool free_of(const QRectF& candidate, const std::vector<QRectF>& taken) {
  return std::none_of(taken.begin(), taken.end(),
                      [&](const QRectF& rect) { return candidate.intersects(rect); });
}

// Points along the segment between two ends, so that a long straight line is not overlooked.
void add_segment(std::vector<QPointF>& points, const QPointF& from, const QPointF& to,
                 const QRectF& inside) {
  if (!inside.intersects(QRectF(from, to).normalized().adjusted(-1, -1, 1, 1))) return;
  const QPointF way = to - from;
  const double length = std::min(std::hypot(way.x(), way.y()), kLongestLine);
  const int steps = static_cast<int>(length / kLineStep) + 1;
  for (int i = 1; i <= steps; ++i) points.push_back(from + way * i / steps);
}

// Where the plot's graphs and curves run, in pixels.
std::vector<QPointF> lines_of(const QCPAxisRect& axes, const QRectF& inside) {
  std::vector<QPointF> points;
  for (auto* plottable : axes.plottables()) {
    const auto* curve = qobject_cast<QCPCurve*>(plottable);
    if (curve != nullptr && curve->lineStyle() == QCPCurve::lsNone) continue;
    auto* data = plottable->interface1D();
    if (data == nullptr) continue;
    std::optional<QPointF> before;  // none behind a gap in the line: a value that is not known
    for (int k = 0; k < data->dataCount(); ++k) {
      const auto at = plottable->coordsToPixels(data->dataMainKey(k), data->dataMainValue(k));
      if (!std::isfinite(at.x()) || !std::isfinite(at.y())) {
        before.reset();
        continue;
      }
      if (before) add_segment(points, *before, at, inside);
      before = at;
    }
  }
  return points;
}

// Of the markers that stand in the rectangle without a line between them.
std::vector<QRectF> markers_in(const QCPAxisRect& axes) {
  std::vector<QRectF> markers;
  for (auto* plottable : axes.plottables()) {
    const auto* curve = qobject_cast<QCPCurve*>(plottable);
    if (curve == nullptr || curve->lineStyle() != QCPCurve::lsNone) continue;
    const double size = curve->scatterStyle().size() + 2;
    for (const auto& point : *curve->data()) {
      const QPointF at = curve->coordsToPixels(point.key, point.value);
      markers.emplace_back(at.x() - size / 2, at.y() - size / 2, size, size);
    }
  }
  return markers;
}

// Of the words that stand in the rectangle already.
std::vector<QRectF> words_in(const QCPAxisRect& axes) {
  std::vector<QRectF> words;
  for (auto* item : axes.items())
    if (auto* text = qobject_cast<QCPItemText*>(item))
      words.push_back(QRectF(text->topLeft->pixelPosition(), text->bottomRight->pixelPosition())
                          .adjusted(-1, -1, 1, 1));  // texts stand on whole pixels
  return words;
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

// From a point to the nearest place of a text that stands away from it.
void lead(QCustomPlot& plot, const QPointF& point, const QRectF& place) {
  auto* leader = new QCPItemLine(&plot);
  leader->setClipToAxisRect(false);
  leader->setPen(line(kGrey, 0.7));
  for (auto* end : {leader->start, leader->end}) end->setType(QCPItemPosition::ptAbsolute);
  leader->start->setCoords(point);
  leader->end->setCoords(std::clamp(point.x(), place.left() + 2, place.right() - 2),
                         std::clamp(point.y(), place.top() + 2, place.bottom() - 2));
  leader->setLayer("grid");  // behind the markers
}

}  // namespace

void place_labels(QCustomPlot& plot, const std::vector<PointLabel>& labels) {
  place_labels(*plot.axisRect(), labels);
}

void place_labels(QCPAxisRect& rect, const std::vector<PointLabel>& labels) {
  QCustomPlot& plot = *rect.parentPlot();
  plot.replot();  // the layout gives pixels their meaning
  const QFontMetricsF metrics(label_font());
  const QRectF inside = rect.rect();
  const auto lines = lines_of(rect, inside);
  std::vector<QRectF> taken = words_in(rect);
  const auto markers = markers_in(rect);
  taken.insert(taken.end(), markers.begin(), markers.end());
  std::vector<QPointF> points;
  for (const auto& label : labels) {
    points.emplace_back(rect.axis(QCPAxis::atBottom)->coordToPixel(label.x),
                        rect.axis(QCPAxis::atLeft)->coordToPixel(label.y));
    taken.emplace_back(points.back().x() - kMarker / 2, points.back().y() - kMarker / 2, kMarker,
                       kMarker);
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double width = metrics.horizontalAdvance(QString::fromStdString(labels[i].text)) + 4;
    const double height = metrics.height();
    std::optional<QRectF> best;
    std::ptrdiff_t least = 0;
    bool far = false;
    const auto look_around = [&](double away) {
      for (const auto& side : kSides) {
        const QPointF centre = points[i] + QPointF(side.x * ((width + kMarker + 2) / 2 + away),
                                                   side.y * ((height + kMarker + 2) / 2 + away));
        const QRectF place(centre.x() - width / 2, centre.y() - height / 2, width, height);
        if (!inside.contains(place) || !free_of(place, taken)) continue;
        const auto covered = std::count_if(lines.begin(), lines.end(),
                                           [&](const QPointF& p) { return place.contains(p); });
        if (best && covered >= least) continue;
        best = place;
        least = covered;
        far = away > 0;
      }
    };
    look_around(0);
    for (const double away : kFarther)
      if (!best || least > kMuch) look_around(away);
    if (!best) continue;
    if (far) lead(plot, points[i], *best);
    write(plot, labels[i], best->center());
    taken.push_back(*best);
  }
}

}  // namespace triax::src
