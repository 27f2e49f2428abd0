// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/history_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"
#include "src/triaxial/figures/joined_line.hpp"
#include "src/triaxial/figures/origin_note.hpp"
#include "src/triaxial/figures/panels.hpp"

namespace triax::src {
namespace {

// A panel shows at least this part of what its quantity did in the whole test: a close view of a
// quantity that is held shall not be filled with the noise of its transducer.
constexpr double kLeastPart = 0.02;

struct Panel {
  std::string title;
  QColor colour;
  double unit;       ///< SI values are multiplied with this
  double least = 0;  ///< that the axis shows, in its unit: less is noise
};

Panel panel_for(study::HistoryQuantity quantity) {
  using enum study::HistoryQuantity;
  switch (quantity) {
    case q:
      return {"q (kPa)", kBlue, 1e-3, 0.5};
    case pore_pressure:
      return {"u (kPa)", kGreen, 1e-3, 0.5};
    case volumetric_strain:
      return {"ε_v (%)", kGreen, 100, 0.02};
    case axial_strain:
      return {"ε₁ (%)", kOrange, 100, 0.005};
  }
  return {};
}

void fill_panel(QCPAxisRect& rect, const Panel& panel, const study::HistoryCurve& curve,
                const study::HistoryAxis& axis) {
  RangeOf range;
  JoinedLine joined;
  for (const auto& [at, value, join] : curve.points) {
    joined.add({at, value * panel.unit}, join);
    range.add(value * panel.unit);
  }
  range.widen_to(panel.least);
  range.widen_to(kLeastPart * (curve.largest * panel.unit - curve.smallest * panel.unit));
  rect.axis(QCPAxis::atLeft)->setRange(range.with_margin(0.08, false));

  const QPointF scale(kHistoryWidth * axis.unit / (axis.end - axis.begin),
                      kPanelHeight / rect.axis(QCPAxis::atLeft)->range().size());
  draw_joined(rect, joined, line(panel.colour, 1.6), [&](const QPointF& point) {
    return QPointF(point.x() * scale.x(), point.y() * scale.y());
  });
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
    if (std::isnan(normalised)) {
      low->addData(at, normalised);
      high->addData(at, normalised);
      continue;
    }
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

Mark mark_for(const study::HistoryMark& mark) {
  using enum study::HistoryMarkKind;
  switch (mark.kind) {
    case onset:
      return {mark.at, "onset of instability", line(kVermilion, 1.3, Qt::DashLine)};
    case loss_of_control:
      return {mark.at, "loss of control", line(kPurple, 1.3, Qt::DashDotLine)};
    case failure:
      return {mark.at, "failure, not collapse", line(kGrey, 1.3, Qt::DashLine)};
    case true_onset:
      return {mark.at, "true onset (model)", line(kInk, 1.3, Qt::DotLine)};
  }
  return {};
}

std::string caption(const study::History& history) {
  auto text =
      fmt::format("{} of test {} along {}.",
                  history.span == study::Span::onset ? "The same around the onset" : "Histories",
                  history.test, history.axis.along_time ? "time" : "its readings");
  if (history.span == study::Span::shear)
    text += " The band around the normalised second-order work is one standard error.";
  return text;
}

}  // namespace

Drawing history_figure(const study::History& history) {
  const auto& axis = history.axis;
  const int count = static_cast<int>(history.curves.size()) + (history.work ? 1 : 0);
  std::vector<Mark> marks;
  for (const auto& mark : history.marks) marks.push_back(mark_for(mark));
  const int names_height = height_of_names(marks);

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
  finish_rows(*plot, axis, {}, names_height);  // NOLINT: the plot owns its margins
  note_below(*plot, origin_note(history.origin));
  draw_marks(*plot, marks);
  return {std::move(plot), caption(history)};
}

}  // namespace triax::src
