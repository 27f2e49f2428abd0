// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/history_figure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/plot/plot_style.hpp"
#include "src/plot/polyline.hpp"
#include "src/plot/shapes.hpp"
#include "src/triaxial/figures/origin_note.hpp"

namespace triax::src {
namespace {

constexpr int kHistoryWidth = 620;
constexpr int kPanelHeight = 150;
constexpr int kAxisHeight = 50;
constexpr int kMarkNameHeight = 16;

// A panel shows at least this part of what its quantity did in the whole test: a close view of a
// quantity that is held shall not be filled with the noise of its transducer.
constexpr double kLeastPart = 0.02;

struct Panel {
  std::string title;
  QColor colour;
  double unit;  ///< SI values are multiplied with this
};

Panel panel_for(study::HistoryQuantity quantity) {
  using enum study::HistoryQuantity;
  switch (quantity) {
    case q:
      return {"q (kPa)", kBlue, 1e-3};
    case pore_pressure:
      return {"u (kPa)", kGreen, 1e-3};
    case volumetric_strain:
      return {"ε_v (%)", kGreen, 100};
    case axial_strain:
      return {"ε₁ (%)", kOrange, 100};
  }
  return {};
}

std::string axis_title(const study::HistoryAxis& axis) {
  if (!axis.along_time) return "axial strain ε₁ (%), no time in the record";
  return fmt::format("time since start of {} ({})", axis.from_shear ? "shear" : "record",
                     axis.unit == 1    ? "s"
                     : axis.unit == 60 ? "min"
                                       : "h");
}

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

void fill_panel(QCPAxisRect& rect, const Panel& panel, const study::HistoryCurve& curve,
                const study::HistoryAxis& axis) {
  auto* graph = add_graph(rect, line(panel.colour, 1.6));
  RangeOf range;
  Points points;
  for (const auto& [at, value] : curve.points) {
    points.emplace_back(at, value * panel.unit);
    range.add(value * panel.unit);
  }
  range.widen_to(kLeastPart * (curve.largest * panel.unit - curve.smallest * panel.unit));
  rect.axis(QCPAxis::atLeft)->setRange(range.with_margin(0.08, false));

  const QPointF scale(kHistoryWidth * axis.unit / (axis.end - axis.begin),
                      kPanelHeight / rect.axis(QCPAxis::atLeft)->range().size());
  auto pixels = points;
  for (auto& point : pixels) point = {point.x() * scale.x(), point.y() * scale.y()};
  for (const auto i : points_to_draw(pixels, kInvisible))
    graph->addData(points[i].x(), points[i].y());
}

void fill_work_panel(QCPAxisRect& rect, const std::vector<study::HistoryWork>& work,
                     study::Span span) {
  auto* low = add_graph(rect, Qt::NoPen);
  auto* high = add_graph(rect, Qt::NoPen);
  auto* value = add_graph(rect, line(kPurple, 1.6));
  RangeOf near;
  near.add(0);
  for (const auto& [at, normalised, error] : work) {
    value->addData(at, normalised);
    low->addData(at, std::max(-1.0, normalised - error));
    high->addData(at, std::min(1.0, normalised + error));
    near.add(normalised - error);
    near.add(normalised + error);
  }
  auto band = kPurple;
  band.setAlpha(50);
  high->setBrush(band);
  high->setChannelFillGraph(low);
  const QCPRange all(-1.1, 1.1);
  rect.axis(QCPAxis::atLeft)
      ->setRange(span == study::Span::onset ? near.with_margin(0.1, false).bounded(-1.1, 1.1)
                                            : all);
  rect.axis(QCPAxis::atLeft)->grid()->setZeroLinePen(line(kInk, 1.2));
}

struct Mark {
  double position;  // on the common axis
  std::string name;
  QPen pen;
};

// A line through all panels.
Mark mark_for(const study::HistoryMark& mark) {
  using enum study::HistoryMarkKind;
  switch (mark.kind) {
    case onset:
      return {mark.at, "onset of collapse", line(kVermilion, 1.3, Qt::DashLine)};
    case failure:
      return {mark.at, "failure on the limit surface", line(kGrey, 1.3, Qt::DashLine)};
    case true_onset:
      return {mark.at, "true onset (model)", line(kInk, 1.3, Qt::DotLine)};
  }
  return {};
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
  text->setPadding(QMargins(0, 0, 0, row * kMarkNameHeight + 1));
  text->setPositionAlignment((right_half ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom);
}

void draw_marks(QCustomPlot& plot, const std::vector<study::HistoryMark>& marks) {
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Mark mark = mark_for(marks[i]);
    for (auto* rect : plot.axisRects()) draw_line(*rect, mark);
    write_name(*plot.axisRects().front(), mark, static_cast<int>(i));
  }
}

std::string caption(const study::History& history) {
  auto text =
      fmt::format("{} of test {} along {}.",
                  history.span == study::Span::onset ? "The same around the onset" : "Histories",
                  history.test, history.axis.along_time ? "time" : "axial strain");
  if (history.span == study::Span::shear)
    text += " The band around the normalised second-order work is one standard error.";
  return text;
}

// One common axis below; rows are as high as what stands above or below their axes, so that all
// panels come out alike.
void finish_rows(QCustomPlot& plot, const study::HistoryAxis& axis, int names_height) {
  const auto rects = plot.axisRects();
  for (auto* rect : rects)
    rect->axis(QCPAxis::atBottom)
        ->setRange((axis.begin - axis.origin) / axis.unit, (axis.end - axis.origin) / axis.unit);
  auto* bottom = rects.back()->axis(QCPAxis::atBottom);
  bottom->setTickLabels(true);
  bottom->setLabel(QString::fromStdString(axis_title(axis)));
  rects.front()->setMinimumMargins(QMargins(10, 6 + names_height, 16, 6));
  const auto last = static_cast<int>(rects.size()) - 1;
  for (int row = 0; row <= last; ++row)
    plot.plotLayout()->setRowStretchFactor(
        row, kPanelHeight + (row == 0 ? names_height : 0) + (row == last ? kAxisHeight : 0));
}

}  // namespace

Drawing history_figure(const study::History& history) {
  const auto& axis = history.axis;
  const int count = static_cast<int>(history.curves.size()) + (history.work ? 1 : 0);
  const int names_height = kMarkNameHeight * static_cast<int>(history.marks.size());

  auto plot =
      make_plot(kHistoryWidth, count * kPanelHeight + kAxisHeight + names_height + kNoteHeight);
  plot->plotLayout()->clear();
  plot->plotLayout()->setRowSpacing(4);
  auto* margins = new QCPMarginGroup(plot.get());
  for (const auto& curve : history.curves) {
    const Panel panel = panel_for(curve.quantity);
    fill_panel(*add_panel(*plot, margins, panel.title), panel, curve, axis);
  }
  if (history.work)
    fill_work_panel(*add_panel(*plot, margins, "W₂ normalised (–)"), *history.work, history.span);
  finish_rows(*plot, axis, names_height);
  note_below(*plot, origin_note(history.origin));
  draw_marks(*plot, history.marks);
  return {std::move(plot), caption(history)};
}

}  // namespace triax::src
