// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/panels.hpp"

#include <fmt/format.h>

#include "src/plot/plot_style.hpp"

namespace triax::src {
namespace {

constexpr int kMarkNameHeight = 16;
constexpr int kOffBox = 3;

std::string axis_title(const study::HistoryAxis& axis) {
  if (!axis.along_time) return "reading (no time in the record)";
  return fmt::format("time since start of {} ({})", axis.from_shear ? "shear" : "record",
                     axis.unit == 1    ? "s"
                     : axis.unit == 60 ? "min"
                                       : "h");
}

void draw_line(QCPAxisRect& rect, const Mark& mark) {
  auto* item = new QCPItemLine(rect.parentPlot());
  item->setClipAxisRect(&rect);
  item->setPen(mark.pen);
  for (auto* end : {item->start, item->end}) {
    end->setAxisRect(&rect);
    end->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    end->setTypeX(QCPItemPosition::ptPlotCoords);
    end->setTypeY(QCPItemPosition::ptAxisRectRatio);
  }
  item->start->setCoords(mark.position, 0);
  item->end->setCoords(mark.position, 1);
}

// Names stand above the top panel, each mark's in a row of its own: marks may be close together.
void write_name(QCPAxisRect& top, const Mark& mark, int row) {
  const bool right_half = mark.position > top.axis(QCPAxis::atBottom)->range().center();
  auto* text = new QCPItemText(top.parentPlot());
  text->setClipToAxisRect(false);
  text->setFont(label_font());
  text->setColor(mark.pen.color());
  text->setText(QString::fromStdString(mark.name));
  auto& at = *text->position;
  at.setAxisRect(&top);
  at.setAxes(top.axis(QCPAxis::atBottom), top.axis(QCPAxis::atLeft));
  at.setTypeX(QCPItemPosition::ptPlotCoords);
  at.setTypeY(QCPItemPosition::ptAxisRectRatio);
  at.setCoords(mark.position, 0);
  text->setPadding(QMargins(0, 0, 0, row * kMarkNameHeight + kOffBox));
  text->setPositionAlignment((right_half ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom);
}

}  // namespace

QCPAxisRect* add_panel(QCustomPlot& plot, QCPMarginGroup* margins, const std::string& title) {
  auto* rect = new QCPAxisRect(&plot, true);
  style_axes(*rect, "", title);
  rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
  rect->setMinimumMargins(QMargins(10, 6, 16, 6));
  rect->axis(QCPAxis::atBottom)->setTickLabels(false);
  rect->axis(QCPAxis::atLeft)->ticker()->setTickCount(4);
  plot.plotLayout()->addElement(plot.plotLayout()->rowCount(), 0, rect);
  return rect;
}

QCPGraph* add_graph(QCPAxisRect& rect, const QPen& pen) {
  auto* plot = rect.parentPlot();
  auto* graph = plot->addGraph(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  graph->setPen(pen);
  return graph;
}

int height_of_names(const std::vector<Mark>& marks) {
  return marks.empty() ? 0 : kMarkNameHeight * static_cast<int>(marks.size()) + kOffBox;
}

void draw_marks(QCustomPlot& plot, const std::vector<Mark>& marks) {
  for (std::size_t i = 0; i < marks.size(); ++i) {
    for (auto* rect : plot.axisRects()) draw_line(*rect, marks[i]);
    write_name(*plot.axisRects().front(), marks[i], static_cast<int>(i));
  }
}

void finish_rows(QCustomPlot& plot, const study::HistoryAxis& axis, const std::vector<int>& heights,
                 int names_height) {
  const auto rects = plot.axisRects();
  for (auto* rect : rects)
    rect->axis(QCPAxis::atBottom)
        ->setRange((axis.begin - axis.origin) / axis.unit, (axis.end - axis.origin) / axis.unit);
  auto* bottom = rects.back()->axis(QCPAxis::atBottom);
  bottom->setTickLabels(true);
  bottom->setLabel(QString::fromStdString(axis_title(axis)));
  rects.front()->setMinimumMargins(QMargins(10, 6 + names_height, 16, 6));
  const auto height = [&](int row) {
    const auto place = static_cast<std::size_t>(row);
    return place < heights.size() ? heights[place] : kPanelHeight;
  };
  const auto last = static_cast<int>(rects.size()) - 1;
  for (int row = 0; row <= last; ++row)
    plot.plotLayout()->setRowStretchFactor(
        row, height(row) + (row == 0 ? names_height : 0) + (row == last ? kAxisHeight : 0));
}

}  // namespace triax::src
