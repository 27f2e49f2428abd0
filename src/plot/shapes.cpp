// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/shapes.hpp"

#include <array>
#include <cmath>

#include "src/plot/plot_style.hpp"

namespace triax::src {
namespace {

QCPCurve* add_points(QCPAxisRect& rect, const Points& points, const std::string& name) {
  auto* curve = new QCPCurve(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  QVector<QCPCurveData> data;
  data.reserve(static_cast<qsizetype>(points.size()));
  for (const auto& point : points)
    data.append({static_cast<double>(data.size()), point.x(), point.y()});
  curve->data()->set(data, true);
  if (name.empty())
    curve->removeFromLegend();
  else
    curve->setName(QString::fromStdString(name));
  return curve;
}

}  // namespace

QCPCurve* draw_curve(QCPAxisRect& rect, const Points& points, const QPen& pen,
                     const std::string& name) {
  auto* curve = add_points(rect, points, name);
  curve->setPen(pen);
  return curve;
}

QCPCurve* draw_area(QCPAxisRect& rect, const Points& points, const QColor& fill, const QPen& border,
                    const std::string& name) {
  auto closed = points;
  if (!closed.empty()) closed.push_back(closed.front());
  auto* area = draw_curve(rect, closed, border, name);
  area->setBrush(fill);
  return area;
}

void lay_behind(QCPAbstractPlottable& plottable) { plottable.setLayer("grid"); }

QCPCurve* draw_markers(QCPAxisRect& rect, const Points& points, const QCPScatterStyle& marker,
                       const std::string& name) {
  auto* markers = add_points(rect, points, name);
  markers->setLineStyle(QCPCurve::lsNone);
  markers->setScatterStyle(marker);
  return markers;
}

QCPCurve* draw_arrow(QCPAxisRect& rect, const QPointF& from, const QPointF& to, const QPen& pen,
                     const std::string& name, double head_px) {
  // The head is an item of its own; the shaft is a curve, so that labels keep off it.
  auto* head = new QCPItemLine(rect.parentPlot());
  for (auto* position : {head->start, head->end}) {
    position->setAxisRect(&rect);
    position->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    position->setType(QCPItemPosition::ptPlotCoords);
  }
  head->start->setCoords(from);
  head->end->setCoords(to);
  auto tip = pen;
  tip.setStyle(Qt::SolidLine);
  head->setPen(tip);
  head->setHead(QCPLineEnding(QCPLineEnding::esSpikeArrow, 0.7 * head_px, head_px));
  head->setClipToAxisRect(false);
  return draw_curve(rect, {from, to}, pen, name);
}

void write_text(QCPAxisRect& rect, const QPointF& at, const std::string& text, const QColor& colour,
                Qt::Alignment part) {
  auto* item = new QCPItemText(rect.parentPlot());
  item->setClipToAxisRect(false);
  item->setFont(label_font());
  item->setColor(colour);
  item->setText(QString::fromStdString(text));
  item->setPositionAlignment(part);
  item->position->setAxisRect(&rect);
  item->position->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  item->position->setType(QCPItemPosition::ptPlotCoords);
  item->position->setCoords(at);
}

Qt::Alignment part_away(const QPointF& middle, const QPointF& at) {
  const QPointF out = at - middle;
  const double size = std::hypot(out.x(), out.y());
  Qt::Alignment part;
  part |= out.x() > 0.3 * size    ? Qt::AlignLeft
          : out.x() < -0.3 * size ? Qt::AlignRight
                                  : Qt::AlignHCenter;
  part |= out.y() > 0.3 * size    ? Qt::AlignBottom
          : out.y() < -0.3 * size ? Qt::AlignTop
                                  : Qt::AlignVCenter;
  return part;
}

Qt::PenStyle curve_style(std::size_t index) {
  static constexpr std::array kStyles = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine,
                                         Qt::DashDotDotLine};
  return kStyles.at(index % kStyles.size());
}

QPen curve_pen(std::size_t index, double width) {
  static const std::array kColours = {kBlue, kVermilion, kGreen, kPurple, kInk, kOrange};
  return line(kColours.at(index % kColours.size()), width, curve_style(index));
}

}  // namespace triax::src
