// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/plot_style.hpp"

#include <algorithm>
#include <cmath>

namespace triax::src {
namespace {

constexpr double kLeastRange = 2e-4;  // of the largest value
constexpr QMargins kLegendMargins(50, 0, 10, 4);

}  // namespace

QFont label_font() {
  QFont font("DejaVu Sans");
  font.setStyleHint(QFont::SansSerif);
  font.setPixelSize(12);
  return font;
}

QFont text_font(double points) {
  auto font = label_font();
  font.setPointSizeF(points);
  return font;
}

QFont title_font() {
  auto font = label_font();
  font.setPixelSize(13);
  return font;
}

QPen line(const QColor& colour, double width, Qt::PenStyle style) {
  QPen pen(colour);
  pen.setWidthF(width);
  pen.setStyle(style);
  pen.setJoinStyle(Qt::RoundJoin);
  return pen;
}

void style_axes(QCPAxisRect& rect, const std::string& x_title, const std::string& y_title) {
  rect.setupFullAxesBox(true);
  for (auto* axis : rect.axes()) {
    axis->setBasePen(line(kInk, 1));
    axis->setTickPen(line(kInk, 1));
    axis->setSubTickPen(line(kGrey, 1));
    axis->setTickLengthIn(0);
    axis->setSubTickLengthIn(0);
    axis->setTickLabelFont(label_font());
    axis->setLabelFont(title_font());
    axis->setTickLabelColor(kInk);
    axis->setLabelColor(kInk);
    axis->setNumberFormat("g");
    axis->grid()->setPen(line(kGridLine, 1));
    axis->grid()->setZeroLinePen(line(kGrey, 1));
  }
  // Ticks point outwards on the two labelled axes only: nothing crosses the data.
  rect.axis(QCPAxis::atTop)->setTicks(false);
  rect.axis(QCPAxis::atRight)->setTicks(false);
  for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft}) {
    rect.axis(side)->setTickLengthOut(5);
    rect.axis(side)->setSubTickLengthOut(2);
  }
  rect.axis(QCPAxis::atBottom)->setLabel(QString::fromStdString(x_title));
  rect.axis(QCPAxis::atLeft)->setLabel(QString::fromStdString(y_title));
}

void style_legend(QCPLegend& legend) {
  legend.setVisible(true);
  legend.setFont(label_font());
  legend.setTextColor(kInk);
  legend.setBorderPen(Qt::NoPen);
  legend.setBrush(Qt::NoBrush);
  legend.setIconSize(28, 16);  // as high as a line of text, or descenders are cut
  legend.setRowSpacing(1);
  legend.setColumnSpacing(16);
}

namespace {

/// Columns of the legend that the plot's width has room for, by its widest entry; at least one.
int fitting_columns(const QCustomPlot& plot) {
  constexpr int kBesideText = 28 + 8 + 16;  // icon, what it keeps off the text, space of columns
  const QFontMetrics metrics(label_font());
  int widest = 1;
  for (int i = 0; i < plot.legend->itemCount(); ++i)
    if (auto* item = qobject_cast<QCPPlottableLegendItem*>(plot.legend->item(i)))
      widest = std::max(widest, metrics.horizontalAdvance(item->plottable()->name()));
  return std::max(
      1, (plot.width() - kLegendMargins.left() - kLegendMargins.right()) / (widest + kBesideText));
}

}  // namespace

void legend_below(QCustomPlot& plot, int columns) {
  style_legend(*plot.legend);
  plot.axisRect()->insetLayout()->take(plot.legend);
  auto* row = new QCPLayoutGrid;
  const int rows = plot.plotLayout()->rowCount();
  plot.plotLayout()->addElement(rows, 0, row);
  row->addElement(0, 0, plot.legend);
  row->setMargins(kLegendMargins);
  plot.plotLayout()->setRowStretchFactor(rows, 0.001);
  plot.legend->setWrap(std::min(columns, fitting_columns(plot)));
  plot.legend->setFillOrder(QCPLayoutGrid::foColumnsFirst, true);
}

void RangeOf::add(double value) {
  if (!std::isfinite(value)) return;
  low_ = empty_ ? value : std::min(low_, value);
  high_ = empty_ ? value : std::max(high_, value);
  empty_ = false;
}

void RangeOf::widen_to(double width) {
  const double lack = width - this->width();
  if (empty_ || !(lack > 0)) return;
  low_ -= lack / 2;
  high_ += lack / 2;
}

QCPRange RangeOf::with_margin(double margin, bool keep_zero) const {
  if (empty_) return {0, 1};
  double width = high_ - low_;
  const double size = std::max(std::abs(low_), std::abs(high_));
  if (width <= 1e-12 * size) width = std::max(std::abs(high_) * 0.1, 1e-6);
  // Numbers of six digits tell ticks apart only where the range is wider than this.
  if (const double lack = kLeastRange * size - width; lack > 0)
    return {low_ - lack / 2 - margin * size * kLeastRange,
            high_ + lack / 2 + margin * size * kLeastRange};
  const bool keep_low = keep_zero && low_ == 0;
  const bool keep_high = keep_zero && high_ == 0 && low_ < 0;
  return {low_ - (keep_low ? 0 : margin * width), high_ + (keep_high ? 0 : margin * width)};
}

}  // namespace triax::src
